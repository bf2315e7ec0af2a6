#include "loosefit/io/config_node.h"

#include <fmt/format.h>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/text.h"

namespace loosefit::io {

const ConfigNode* ConfigNode::find(const std::string& key) const {
  for (const auto& [name, node] : members)
    if (name == key) return &node;
  return nullptr;
}

std::string ConfigNode::describe() const {
  switch (kind) {
    case Kind::boolean:
      return boolean ? "true" : "false";
    case Kind::integer:
      return std::to_string(integer);
    case Kind::number:
      return shortest(number);
    case Kind::text:
      return "\"" + printable(text) + "\"";
    case Kind::other:
      return "a " + text;
    case Kind::array:
      return fmt::format("an array of {}", items.size());
    case Kind::table:
      return "a table";
  }
  return "?";
}

std::string toml_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return replace_controls(quoted + "\"", [](const std::string& s) -> std::string {
    const auto code = static_cast<unsigned>(code_point(s));
    if (s.size() == 1 && code >= 0x80) return s;  // no UTF-8, so no character either
    return code < 0x10000 ? fmt::format("\\u{:04x}", code) : fmt::format("\\U{:08x}", code);
  });
}

}  // namespace loosefit::io
