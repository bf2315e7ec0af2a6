#include "loosefit/io/toml_file.h"

#include <toml++/toml.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMaxBytes = 1000000;
// A dotted key nests one table per dot and cannot span lines, so a short line bounds the depth
// before the parser (which recurses when it frees its tables) sees the text.
constexpr std::size_t kMaxLine = 2000;
constexpr int kMaxDepth = 32;

ConfigNode converted(const toml::node& node, const std::string& file, int depth) {
  ConfigNode result;
  result.line = static_cast<int>(node.source().begin.line);
  if (depth > kMaxDepth)
    throw InvalidInput({file, result.line, ""}, "values nested more than 32 deep",
                       "a flat file of sections and keys");
  if (const auto* flag = node.as_boolean()) {
    result.kind = ConfigNode::Kind::boolean;
    result.boolean = flag->get();
  } else if (const auto* whole = node.as_integer()) {
    result.kind = ConfigNode::Kind::integer;
    result.integer = whole->get();
    result.number = static_cast<double>(whole->get());
  } else if (const auto* real = node.as_floating_point()) {
    result.kind = ConfigNode::Kind::number;
    result.number = real->get();
  } else if (const auto* text = node.as_string()) {
    result.kind = ConfigNode::Kind::text;
    result.text = text->get();
  } else if (const auto* array = node.as_array()) {
    result.kind = ConfigNode::Kind::array;
    for (const toml::node& item : *array) result.items.push_back(converted(item, file, depth + 1));
  } else if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      result.members.emplace_back(std::string(key.str()), converted(value, file, depth + 1));
    std::stable_sort(result.members.begin(), result.members.end(),
                     [](const auto& a, const auto& b) { return a.second.line < b.second.line; });
  } else {
    result.kind = ConfigNode::Kind::other;
    result.text = node.is_date() ? "date" : node.is_time() ? "time" : "date and time";
  }
  return result;
}

void refuse_long_lines(const std::string& text, const std::string& file) {
  std::size_t start = 0;
  for (int line = 1; start < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    if (end - start > kMaxLine)
      throw InvalidInput({file, line, ""}, "a line of " + std::to_string(end - start) + " bytes",
                         "TOML with lines of at most 2000 bytes");
    start = end + 1;
  }
}

}  // namespace

ConfigNode parse_toml(const std::string& text, const std::string& file) {
  if (text.size() > kMaxBytes)
    throw InvalidInput({file, 0, ""}, std::to_string(text.size()) + " bytes",
                       "a TOML file of at most 1 MB");
  refuse_long_lines(text, file);
  try {
    return converted(toml::parse(text, file), file, 0);
  } catch (const toml::parse_error& e) {
    const int line = static_cast<int>(e.source().begin.line);
    throw InvalidInput({file, line, ""}, printable(std::string(e.description()), 200), "valid TOML",
                       "syntax: key = value, [section], text in \"quotes\"");
  }
}

ConfigNode read_toml(const std::string& path) {
  return parse_toml(read_text_file(path, kMaxBytes), path);
}

}  // namespace loosefit::io
