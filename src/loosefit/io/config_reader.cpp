#include "loosefit/io/config_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

using Kind = ConfigNode::Kind;

bool is_number(const ConfigNode& node) {
  return node.kind == Kind::integer || node.kind == Kind::number;
}

bool within(double value, const NumberRange& range) {
  return value >= range.low && value <= range.high;  // false for NaN
}

std::string expected_number(const NumberRange& range) {
  const double huge = std::numeric_limits<double>::max();
  if (range.low <= -huge && range.high >= huge) return range.what;
  return fmt::format("{} from {} to {}", range.what, range.low, range.high);
}

// Lengths are the values people most often give in another unit.
std::string unit_hint(double value, const NumberRange& range) {
  if (range.what.rfind("metres", 0) != 0 || !std::isfinite(value)) return {};
  for (const auto& [factor, unit] : {std::pair(0.01, "cm"), std::pair(0.001, "mm")})
    if (within(value * factor, range))
      return fmt::format("lengths are in metres: {:g} {} is {:g}", value, unit, value * factor);
  return {};
}

}  // namespace

ConfigReader::ConfigReader(const ConfigNode& table, std::string file, std::string path)
    : table_(&table), file_(std::move(file)), path_(std::move(path)) {
  if (table.kind != Kind::table)
    throw InvalidInput({file_, table.line, path_}, table.describe(), "a table of keys");
}

const ConfigNode* ConfigReader::node(const std::string& key) {
  asked_.insert(key);
  return table_->find(key);
}

InvalidInput ConfigReader::error(const std::string& key, const std::string& expected,
                                 const std::string& hint) const {
  const ConfigNode* node = table_->find(key);
  return error(key, node ? node->describe() : "nothing", expected, hint);
}

InvalidInput ConfigReader::error(const std::string& key, const std::string& found,
                                 const std::string& expected, const std::string& hint) const {
  const ConfigNode* node = table_->find(key);
  const std::string full = path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
  return InvalidInput({file_, node ? node->line : table_->line, printable(full, 100)}, found,
                      expected, hint);
}

std::optional<double> ConfigReader::optional_number(const std::string& key,
                                                    const NumberRange& range) {
  const ConfigNode* node = this->node(key);
  if (!node) return std::nullopt;
  if (!is_number(*node)) throw error(key, expected_number(range));
  if (!within(node->number, range))
    throw error(key, expected_number(range), unit_hint(node->number, range));
  return node->number;
}

double ConfigReader::number(const std::string& key, double fallback, const NumberRange& range) {
  return optional_number(key, range).value_or(fallback);
}

long long ConfigReader::integer(const std::string& key, long long fallback, long long low,
                                long long high) {
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::integer || node->integer < low || node->integer > high)
    throw error(key, fmt::format("a whole number from {} to {}", low, high));
  return node->integer;
}

bool ConfigReader::boolean(const std::string& key, bool fallback) {
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::boolean) throw error(key, "true or false");
  return node->boolean;
}

std::string ConfigReader::text(const std::string& key, const std::string& fallback) {
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::text) throw error(key, "text in quotes");
  if (node->text.empty()) throw error(key, "text that is not empty");
  if (node->text.find('\0') != std::string::npos) throw error(key, "text without a zero byte");
  return node->text;
}

std::string ConfigReader::choice(const std::string& key, const std::string& fallback,
                                 const std::vector<std::string>& known) {
  const std::string value = text(key, fallback);
  if (has(key) && std::find(known.begin(), known.end(), value) == known.end())
    throw error(key, "one of " + join(known),
                closest_match(value, known).empty() ? std::string() : did_you_mean(value, known));
  return value;
}

std::vector<std::string> ConfigReader::choices(const std::string& key,
                                               const std::vector<std::string>& fallback,
                                               const std::vector<std::string>& known) {
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::array) throw error(key, "an array of texts from " + join(known));
  std::vector<std::string> values;
  for (const ConfigNode& item : node->items) {
    if (item.kind != Kind::text || std::find(known.begin(), known.end(), item.text) == known.end())
      throw error(key, item.describe(), "texts from " + join(known),
                  item.kind == Kind::text && !closest_match(item.text, known).empty()
                      ? did_you_mean(item.text, known)
                      : std::string());
    if (std::find(values.begin(), values.end(), item.text) != values.end())
      throw error(key, item.describe() + " twice", "each at most once", {});
    values.push_back(item.text);
  }
  return values;
}

Vec2 ConfigReader::point_of(const std::string& key, const ConfigNode& node,
                            const NumberRange& range) const {
  if (node.kind != Kind::array || node.items.size() != 2 || !is_number(node.items[0]) ||
      !is_number(node.items[1]))
    throw error(key, node.describe(), "a point [u, v] in metres", {});
  for (const ConfigNode& item : node.items)
    if (!within(item.number, range))
      throw error(key, item.describe(), expected_number(range), unit_hint(item.number, range));
  return {node.items[0].number, node.items[1].number};
}

Vec2 ConfigReader::point(const std::string& key, const NumberRange& range) {
  const ConfigNode* node = this->node(key);
  if (!node) throw error(key, "a point [u, v] in metres");
  return point_of(key, *node, range);
}

std::vector<Vec2> ConfigReader::points(const std::string& key, const NumberRange& range,
                                       std::size_t at_least) {
  const ConfigNode* node = this->node(key);
  if (!node || node->kind != Kind::array || node->items.size() < at_least ||
      node->items.size() > 1000)
    throw error(key, fmt::format("an array of {} to 1000 points [u, v] in metres", at_least));
  std::vector<Vec2> values;
  for (const ConfigNode& item : node->items) values.push_back(point_of(key, item, range));
  return values;
}

std::vector<double> ConfigReader::numbers(const std::string& key, const NumberRange& range) {
  const ConfigNode* node = this->node(key);
  if (!node || node->kind != Kind::array || node->items.empty() || node->items.size() > 1000)
    throw error(key, "an array of 1 to 1000 numbers: " + expected_number(range));
  std::vector<double> values;
  for (const ConfigNode& item : node->items) {
    if (!is_number(item) || !within(item.number, range))
      throw error(key, item.describe(), expected_number(range), {});
    values.push_back(item.number);
  }
  return values;
}

ConfigReader ConfigReader::table(const std::string& key) {
  static const ConfigNode kEmpty;
  const ConfigNode* node = this->node(key);
  return {node ? *node : kEmpty, file_, path_.empty() ? key : path_ + "." + key};
}

std::vector<ConfigReader> ConfigReader::tables(const std::string& key) {
  const ConfigNode* node = this->node(key);
  if (!node) return {};
  if (node->kind != Kind::array)
    throw error(key, "an array of tables", "write [[" + key + "]] with double brackets");
  if (node->items.size() > 200) throw error(key, "at most 200 tables");
  std::vector<ConfigReader> readers;
  for (const ConfigNode& item : node->items)
    readers.emplace_back(item, file_, key + "[" + std::to_string(readers.size()) + "]");
  return readers;
}

void ConfigReader::only(const std::vector<std::string>& known) const {
  for (const auto& [key, node] : table_->members)
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw error(key, "an unknown key", path_.empty() ? "a known section" : "a key of " + path_,
                  did_you_mean(key, known));
}

void ConfigReader::finish() const { only({asked_.begin(), asked_.end()}); }

std::vector<std::string> ConfigReader::keys() const {
  std::vector<std::string> names;
  for (const auto& member : table_->members) names.push_back(member.first);
  return names;
}

}  // namespace loosefit::io
