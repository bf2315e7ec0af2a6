#include "loosefit/study/config_patch.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::study {
namespace {

using Kind = io::ConfigNode::Kind;

struct Step {
  std::string key;
  std::optional<std::size_t> index;
};

std::vector<Step> steps_of(const std::string& dotted) {
  std::vector<Step> steps;
  std::size_t at = 0;
  while (at <= dotted.size()) {
    const std::size_t end = std::min(dotted.find('.', at), dotted.size());
    std::string key = dotted.substr(at, end - at);
    Step step;
    if (const std::size_t open = key.find('['); open != std::string::npos && key.back() == ']') {
      std::size_t index = 0;
      const char* last = key.data() + key.size() - 1;
      const auto read = std::from_chars(key.data() + open + 1, last, index);
      if (read.ec != std::errc() || read.ptr != last)
        throw InvalidInput({"", 0, printable(dotted)}, "\"" + printable(key) + "\"",
                           "a key like site[0]");
      step.index = index;
      key.resize(open);
    }
    if (key.empty())
      throw InvalidInput({"", 0, printable(dotted)}, "an empty part", "keys with dots between");
    step.key = key;
    steps.push_back(step);
    at = end + 1;
  }
  return steps;
}

io::ConfigNode* member(io::ConfigNode& table, const std::string& key) {
  for (auto& [name, node] : table.members)
    if (name == key) return &node;
  return nullptr;
}

void add_keys(const io::ConfigNode& table, const std::string& before, std::set<std::string>& keys) {
  for (const auto& [name, node] : table.members)
    if (node.kind == Kind::table)
      add_keys(node, before + name + ".", keys);
    else
      keys.insert(before + name);
}

}  // namespace

io::ConfigNode number_node(double value, int line) {
  io::ConfigNode node;
  node.kind = Kind::number;
  node.number = value;
  node.line = line;
  return node;
}

io::ConfigNode integer_node(long long value, int line) {
  io::ConfigNode node = number_node(static_cast<double>(value), line);
  node.kind = Kind::integer;
  node.integer = value;
  return node;
}

io::ConfigNode text_node(const std::string& text, int line) {
  io::ConfigNode node;
  node.kind = Kind::text;
  node.text = text;
  node.line = line;
  return node;
}

void set_value(io::ConfigNode& root, const std::string& dotted, const io::ConfigNode& value) {
  io::ConfigNode* at = &root;
  for (const Step& step : steps_of(dotted)) {
    if (at->kind != Kind::table)
      throw InvalidInput({"", 0, printable(dotted)}, at->describe() + " before " + step.key,
                         "a table");
    io::ConfigNode* next = member(*at, step.key);
    if (!next) {
      if (step.index)
        throw InvalidInput({"", 0, printable(dotted)}, "no such item",
                           "an item of an array that the base scenario has");
      at->members.emplace_back(step.key, io::ConfigNode{});
      next = &at->members.back().second;
      next->line = value.line;
    }
    if (step.index) {
      if (next->kind != Kind::array || *step.index >= next->items.size())
        throw InvalidInput({"", 0, printable(dotted)}, next->describe(),
                           "an array with item " + std::to_string(*step.index));
      next = &next->items[*step.index];
    }
    at = next;
  }
  *at = value;
}

void merge_tables(io::ConfigNode& base, const io::ConfigNode& patch) {
  for (const auto& [name, node] : patch.members) {
    io::ConfigNode* there = member(base, name);
    if (there && there->kind == Kind::table && node.kind == Kind::table)
      merge_tables(*there, node);
    else if (there)
      *there = node;
    else
      base.members.emplace_back(name, node);
  }
}

void stands_in(io::ConfigNode& node, const std::string& file) {
  node.file = file;
  for (io::ConfigNode& item : node.items) stands_in(item, file);
  for (auto& [name, member] : node.members) stands_in(member, file);
}

const io::ConfigNode* value_at(const io::ConfigNode& root, const std::string& dotted) {
  const io::ConfigNode* at = &root;
  for (const Step& step : steps_of(dotted)) {
    at = at->kind == Kind::table ? at->find(step.key) : nullptr;
    if (!at) return nullptr;
    if (step.index) {
      if (at->kind != Kind::array || *step.index >= at->items.size()) return nullptr;
      at = &at->items[*step.index];
    }
  }
  return at;
}

std::set<std::string> keys_of_values(const io::ConfigNode& table) {
  std::set<std::string> keys;
  add_keys(table, "", keys);
  return keys;
}

std::string value_text(const io::ConfigNode& value) {
  std::vector<std::string> parts;
  switch (value.kind) {
    case Kind::boolean:
      return value.boolean ? "true" : "false";
    case Kind::integer:
      return std::to_string(value.integer);
    case Kind::number:
      return shortest(value.number);
    case Kind::text:
      return io::toml_quoted(value.text);
    case Kind::other:
      return value.text + " of line " + std::to_string(value.line);
    case Kind::array:
      for (const io::ConfigNode& item : value.items) parts.push_back(value_text(item));
      return "[" + join(parts) + "]";
    case Kind::table:
      for (const auto& [name, node] : value.members)
        parts.push_back(io::toml_quoted(name) + " = " + value_text(node));
      std::sort(parts.begin(), parts.end());
      return "{" + join(parts) + "}";
  }
  return "";
}

}  // namespace loosefit::study
