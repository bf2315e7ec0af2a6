#pragma once
#include <map>
#include <string>
#include <vector>

namespace loosefit::io {

/// An element of an XML document with what is in it.
struct XmlElement {
  std::string name;  ///< with its prefix: "path", "sodipodi:namedview"; without the prefix "svg:"
  int line = 0;      ///< of the file
  std::map<std::string, std::string> attributes;  ///< by name with prefix
  std::string text;                               ///< directly in it
  std::vector<XmlElement> children;

  /// Empty without one.
  const std::string& attribute(const std::string& key) const;
};

/// The root of an XML document (expat). Nothing is fetched: external entities stay empty. Text in
/// UTF-16 is read whatever encoding its head names. `file` only appears in messages. \throws
/// InvalidInput with the line: text that is no XML, more than 200 elements within each other, more
/// than 500 000 elements.
XmlElement parse_xml(const std::string& text, const std::string& file);

}  // namespace loosefit::io
