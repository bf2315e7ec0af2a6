#include "loosefit/io/config_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "loosefit/base/text.h"
#include "loosefit/io/text_encoding.h"

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

/// For a text in place of a number that reads as one.
std::string text_hint(const ConfigNode& node) {
  double value = 0;
  if (node.kind != Kind::text || !number_in(node.text, value)) return {};
  return "numbers stand without quotes and with a decimal point: " + shortest(value);
}

ValueForm number_form(const NumberRange& range, const char* type = "number") {
  const double huge = std::numeric_limits<double>::max();
  ValueForm form{.type = type};
  if (range.low > -huge) form.low = range.low;
  if (range.high < huge) form.high = range.high;
  form.unit = unit_of(range);
  return form;
}

ValueForm text_form(const std::vector<std::string>& known = {}, const std::string& pattern = {}) {
  ValueForm form{.type = "string"};
  form.known = known;
  form.pattern = pattern;
  return form;
}

ValueForm array_form(const ValueForm& item, std::size_t least, std::size_t most,
                     bool unique = false) {
  ValueForm form{.type = "array"};
  form.items = {item};
  form.least = least;
  form.most = most;
  form.unique = unique;
  return form;
}

/// A text as JSON; names of ours need no escapes.
std::string quoted(const std::string& text) { return text.empty() ? "" : "\"" + text + "\""; }

std::string quoted(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) all.push_back(quoted(text));
  return "[" + join(all) + "]";
}

constexpr double kInch = 0.0254;                          // [m]
constexpr double kLeastOfTape = 0.05, kMostOfTape = 2.5;  // measures of people [m]

}  // namespace

std::string unit_hint(double value, const NumberRange& range) {
  if (range.what.rfind("metres", 0) != 0 || !std::isfinite(value)) return {};
  // What is a little too large is in metres: nobody counts parts of a centimetre.
  const double size = std::abs(value);
  if (size < 1 && size < 10 * range.high) return {};
  std::string hint;
  for (const auto& [factor, unit] : {std::pair(0.01, "cm"), std::pair(0.001, "mm")})
    if (hint.empty() && within(value * factor, range))
      hint = fmt::format("{:g} {} is {:g}", value, unit, value * factor);
  // Inches are what tapes have; what may be nothing is no tape measure.
  if (range.low >= kLeastOfTape && value * kInch < kMostOfTape && within(value * kInch, range))
    hint += fmt::format("{}{:g} inches is {:.4g}", hint.empty() ? "" : ", ", value, value * kInch);
  return hint.empty() ? hint : "lengths are in metres: " + hint;
}

std::string unit_of(const NumberRange& range) {
  if (range.what == "metres") return "m";
  if (range.what == "seconds") return "s";
  if (range.what == "kilograms") return "kg";
  return range.what.rfind("a ", 0) == 0 || range.what[0] == '"' ? "" : range.what;
}

ConfigReader::ConfigReader(const ConfigNode& table, std::string file, std::string path,
                           TableRecord* record)
    : table_(&table), file_(std::move(file)), path_(std::move(path)), record_(record) {
  if (table.kind != Kind::table)
    throw InvalidInput({table.file.empty() ? file_ : table.file, table.line, path_},
                       table.describe(), "a table of keys");
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
  return InvalidInput({file_of(key), node ? node->line : table_->line, printable(full, 100)}, found,
                      expected, hint);
}

const std::string& ConfigReader::file_of(const std::string& key) const {
  const ConfigNode* node = table_->find(key);
  const std::string& own = node ? node->file : table_->file;
  return own.empty() ? file_ : own;
}

void ConfigReader::note(const std::string& key, const ValueForm& form, const std::string& about,
                        const std::string& fallback) {
  if (!record_) return;
  KeyRecord& record = record_->key(key);
  if (std::find(record.forms.begin(), record.forms.end(), form) == record.forms.end())
    record.forms.push_back(form);
  if (record.about.empty()) record.about = about;
  if (record.fallback.empty()) record.fallback = fallback;
}

void ConfigReader::declare(const std::string& key, const std::string& about,
                           const std::string& usual) {
  if (!record_) return;
  KeyRecord& record = record_->key(key);
  record.about = about;
  record.fallback = quoted(usual);
}

void ConfigReader::only_for(const std::string& key, const std::vector<std::string>& values) {
  if (!record_) return;
  record_->key(key).allowed = values;
  record_->key(key).required = has(key);
}

void ConfigReader::require(const std::string& key, const std::string& expected) {
  if (!has(key)) throw error(key, expected);
  if (record_) record_->key(key).required = true;
}

void ConfigReader::always_true(const std::string& key, const std::string& about,
                               const std::string& expected) {
  ValueForm form{.type = "boolean"};
  form.known = {"true"};
  note(key, form, about);
  const ConfigNode* node = this->node(key);
  if (node && (node->kind != Kind::boolean || !node->boolean)) throw error(key, expected);
}

bool ConfigReader::lacks(const std::string& key, const std::string& other) {
  if (record_) record_->needs.emplace_back(key, other);
  return has(key) && !has(other);
}

bool ConfigReader::clash(const std::string& key, const std::string& other) {
  if (record_) record_->clashes.emplace_back(key, other);
  return has(key) && has(other);
}

std::optional<double> ConfigReader::optional_number(const std::string& key,
                                                    const NumberRange& range,
                                                    const std::string& about,
                                                    std::optional<double> usual) {
  note(key, number_form(range), about, usual ? shortest(*usual) : "");
  const ConfigNode* node = this->node(key);
  if (!node) return std::nullopt;
  if (!is_number(*node)) throw error(key, expected_number(range), text_hint(*node));
  if (!within(node->number, range))
    throw error(key, expected_number(range), unit_hint(node->number, range));
  return node->number;
}

double ConfigReader::number(const std::string& key, double fallback, const NumberRange& range,
                            const std::string& about) {
  return optional_number(key, range, about, fallback).value_or(fallback);
}

long long ConfigReader::integer(const std::string& key, long long fallback, long long low,
                                long long high, const std::string& about) {
  note(key,
       number_form({static_cast<double>(low), static_cast<double>(high), "a number"}, "integer"),
       about, std::to_string(fallback));
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::integer || node->integer < low || node->integer > high)
    throw error(key, fmt::format("a whole number from {} to {}", low, high));
  return node->integer;
}

bool ConfigReader::boolean(const std::string& key, bool fallback, const std::string& about) {
  note(key, ValueForm{.type = "boolean"}, about, fallback ? "true" : "false");
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::boolean) throw error(key, "true or false");
  return node->boolean;
}

std::string ConfigReader::text(const std::string& key, const std::string& fallback,
                               const std::string& about) {
  note(key, text_form(), about, quoted(fallback));
  return peek_text(key, fallback);
}

std::string ConfigReader::path(const std::string& key, const std::string& pattern,
                               const std::string& about) {
  note(key, text_form({}, pattern), about);
  return peek_text(key, "");
}

std::string ConfigReader::peek_text(const std::string& key, const std::string& fallback) {
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::text) throw error(key, "text in quotes");
  if (node->text.empty()) throw error(key, "text that is not empty");
  if (node->text.find('\0') != std::string::npos) throw error(key, "text without a zero byte");
  return node->text;
}

std::string ConfigReader::choice(const std::string& key, const std::string& fallback,
                                 const std::vector<std::string>& known, const std::string& about) {
  note(key, text_form(known), about, quoted(fallback));
  const std::string value = peek_text(key, fallback);
  if (has(key) && std::find(known.begin(), known.end(), value) == known.end())
    throw error(key, "one of " + join(known),
                closest_match(value, known).empty() ? std::string() : did_you_mean(value, known));
  return value;
}

std::vector<std::string> ConfigReader::choices(const std::string& key,
                                               const std::vector<std::string>& fallback,
                                               const std::vector<std::string>& known,
                                               const std::string& about, std::size_t at_least) {
  note(key, array_form(text_form(known), at_least, 0, true), about,
       fallback.empty() ? "" : quoted(fallback));
  const ConfigNode* node = this->node(key);
  if (!node) return fallback;
  if (node->kind != Kind::array) throw error(key, "an array of texts from " + join(known));
  if (node->items.size() < at_least)
    throw error(key, fmt::format("an array of at least {} from {}",
                                 at_least == 1 ? "one" : std::to_string(at_least), join(known)));
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

std::vector<std::string> ConfigReader::texts(const std::string& key, const std::string& pattern,
                                             const std::string& about, std::size_t at_least) {
  note(key, array_form(text_form({}, pattern), at_least, 0, true), about);
  const ConfigNode* node = this->node(key);
  if (!node) return {};
  const std::string expected =
      fmt::format("an array of at least {} in quotes",
                  at_least == 1 ? "one text" : std::to_string(at_least) + " texts");
  if (node->kind != Kind::array || node->items.size() < at_least) throw error(key, expected);
  std::vector<std::string> values;
  for (const ConfigNode& item : node->items) {
    if (item.kind != Kind::text) throw error(key, item.describe(), expected, {});
    if (std::find(values.begin(), values.end(), item.text) != values.end())
      throw error(key, item.describe() + " twice", "each at most once", {});
    values.push_back(item.text);
  }
  return values;
}

std::string ConfigReader::matching(const std::string& key, const std::string& pattern,
                                   const std::string& about) {
  return path(key, pattern, about);
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

Vec2 ConfigReader::point(const std::string& key, const NumberRange& range,
                         const std::string& about) {
  note(key, array_form(number_form(range), 2, 2), about);
  if (record_) record_->key(key).required = true;
  const ConfigNode* node = this->node(key);
  if (!node) throw error(key, "a point [u, v] in metres");
  return point_of(key, *node, range);
}

Vec2 ConfigReader::point_or_zero(const std::string& key, const NumberRange& range,
                                 const std::string& about) {
  note(key, array_form(number_form(range), 2, 2), about, "[0, 0]");
  const ConfigNode* node = this->node(key);
  return node ? point_of(key, *node, range) : Vec2(Vec2::Zero());
}

std::vector<Vec2> ConfigReader::points(const std::string& key, const NumberRange& range,
                                       std::size_t at_least, const std::string& about) {
  note(key, array_form(array_form(number_form(range), 2, 2), at_least, 1000), about);
  if (record_) record_->key(key).required = true;
  const ConfigNode* node = this->node(key);
  if (!node || node->kind != Kind::array || node->items.size() < at_least ||
      node->items.size() > 1000)
    throw error(key, fmt::format("an array of {} to 1000 points [u, v] in metres", at_least));
  std::vector<Vec2> values;
  for (const ConfigNode& item : node->items) values.push_back(point_of(key, item, range));
  return values;
}

std::vector<double> ConfigReader::numbers(const std::string& key, const NumberRange& range,
                                          const std::string& about, std::size_t count) {
  note(key, array_form(number_form(range), count > 0 ? count : 1, count > 0 ? count : 1000), about);
  if (record_) record_->key(key).required = true;
  const ConfigNode* node = this->node(key);
  if (!node || node->kind != Kind::array || node->items.empty() || node->items.size() > 1000)
    throw error(key, "an array of 1 to 1000 numbers: " + expected_number(range));
  std::vector<double> values;
  for (const ConfigNode& item : node->items) {
    if (!is_number(item) || !within(item.number, range))
      throw error(key, item.describe(), expected_number(range), text_hint(item));
    values.push_back(item.number);
  }
  return values;
}

ConfigReader ConfigReader::table(const std::string& key, const std::string& about) {
  static const ConfigNode kEmpty;
  TableRecord* record = nullptr;
  if (record_) {
    KeyRecord& noted = record_->key(key);
    if (noted.about.empty()) noted.about = about;
    noted.tables.push_back(std::make_shared<TableRecord>());
    record = noted.tables.back().get();
  }
  const ConfigNode* node = this->node(key);
  return {node ? *node : kEmpty, file_, path_.empty() ? key : path_ + "." + key, record};
}

std::optional<ConfigReader> ConfigReader::optional_table(const std::string& key,
                                                         const std::string& about) {
  if (has(key)) return table(key, about);
  if (record_) record_->key(key).about = about;
  return std::nullopt;
}

std::vector<ConfigReader> ConfigReader::tables(const std::string& key, const std::string& about,
                                               std::size_t most) {
  if (record_) {
    KeyRecord& noted = record_->key(key);
    noted.about = about;
    noted.list = true;
    noted.most = most;
  }
  const ConfigNode* node = this->node(key);
  if (!node) return {};
  const std::string full = path_.empty() ? key : path_ + "." + key;
  if (node->kind != Kind::array) {
    const std::string head = std::regex_replace(full, std::regex("\\[\\d+\\]"), "");
    throw error(key, "an array of tables", "write [[" + head + "]] with double brackets");
  }
  if (node->items.size() > most)
    throw error(key, fmt::format("{} tables", node->items.size()), fmt::format("at most {}", most),
                {});
  std::vector<ConfigReader> readers;
  for (const ConfigNode& item : node->items) {
    TableRecord* record = nullptr;
    if (record_) {
      record_->key(key).tables.push_back(std::make_shared<TableRecord>());
      record = record_->key(key).tables.back().get();
    }
    readers.emplace_back(item, file_, full + "[" + std::to_string(readers.size()) + "]", record);
  }
  return readers;
}

void ConfigReader::only(const std::vector<std::string>& known) const {
  for (const auto& [key, node] : table_->members)
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw error(key, "an unknown key", path_.empty() ? "a known section" : "a key of " + path_,
                  did_you_mean(key, known));
}

void ConfigReader::finish() const {
  only({asked_.begin(), asked_.end()});
  if (record_) record_->finished = true;
}

std::vector<std::string> ConfigReader::keys() const {
  std::vector<std::string> names;
  for (const auto& member : table_->members) names.push_back(member.first);
  return names;
}

}  // namespace loosefit::io
