#include "loosefit/io/toml_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <regex>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/text_encoding.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMaxBytes = 1000000;
// A dotted key nests one table per dot and cannot span lines, so a short line bounds the depth
// before the parser (which recurses when it frees its tables) sees the text.
constexpr std::size_t kMaxLine = 2000;
constexpr int kMaxDepth = 32;
constexpr const char *kExpected = "a TOML file", *kHint = "TOML is text: key = value, [section]";

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

/// What people write in place of TOML, by the line where its reader stopped.
std::string syntax_hint(const std::string& text, int line) {
  std::size_t start = 0;
  for (int k = 1; k < line && start < text.size(); ++k)
    start = std::min(text.find('\n', start), text.size() - 1) + 1;
  const std::string at = text.substr(start, std::min(text.find('\n', start), text.size()) - start);
  static const std::regex decimal_comma(R"(=\s*[+-]?\d+,\d+|[\[,]\s*\d+,0\d+)"),
      colon(R"(^\s*[\w"-]+\s*:)"), semicolon(R"(;\s*$)");
  std::smatch found;
  if (text.find_first_not_of(" \t\n") != std::string::npos &&
      text[text.find_first_not_of(" \t\n")] == '{')
    return "this looks like JSON; TOML has key = value, [section], text in \"quotes\"";
  if (std::regex_search(at, found, decimal_comma)) {
    const std::string written = found.str().substr(found.str().find_first_of("+-0123456789"));
    std::string right = written;
    right[right.find(',')] = '.';
    return "decimals have a point: " + written + " is " + right;
  }
  for (const char* quote : {"\xe2\x80\x9c", "\xe2\x80\x9d", "\xe2\x80\x9e", "\xe2\x80\x98",
                            "\xe2\x80\x99", "\xc2\xab", "\xc2\xbb"})
    if (at.find(quote) != std::string::npos)
      return "text stands in plain \"quotes\", not in those that a word processor sets";
  if (std::regex_search(at, colon)) return "a key and its value are joined by =, as in key = value";
  if (std::regex_search(at, semicolon)) return "lines end without a semicolon";
  return "syntax: key = value, [section], text in \"quotes\"";
}

}  // namespace

std::string read_toml_text(const std::string& path) {
  const std::string text = read_plain_text(path, kMaxBytes);
  refuse_other_kinds(text, path, kExpected, {"a TOML file", "an empty file"}, kHint);
  return text;
}

ConfigNode parse_toml(const std::string& written, const std::string& file) {
  const std::string text = plain_text(written);
  if (text.size() > kMaxBytes)
    throw InvalidInput({file, 0, ""}, std::to_string(text.size()) + " bytes",
                       "a TOML file of at most 1 MB");
  refuse_other_kinds(text, file, kExpected, {"a TOML file", "an empty file"}, kHint);
  refuse_long_lines(text, file);
  try {
    return converted(toml::parse(text, file), file, 0);
  } catch (const toml::parse_error& e) {
    const int line = static_cast<int>(e.source().begin.line);
    throw InvalidInput({file, line, ""}, printable(std::string(e.description()), 200), "valid TOML",
                       syntax_hint(text, line));
  }
}

ConfigNode read_toml(const std::string& path) { return parse_toml(read_toml_text(path), path); }

}  // namespace loosefit::io
