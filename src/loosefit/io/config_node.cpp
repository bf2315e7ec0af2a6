#include "loosefit/io/config_node.h"

#include <fmt/format.h>

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
    const unsigned char byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (byte < 0x20 || byte == 0x7f)
      quoted += fmt::format("\\u{:04x}", byte);
    else
      quoted += c;
  }
  return quoted + "\"";
}

}  // namespace loosefit::io
