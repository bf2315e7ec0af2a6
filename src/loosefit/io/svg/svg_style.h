#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/io/xml_tree.h"

namespace loosefit::io {

/// Styles of an SVG document: its style sheets, style attributes and presentation attributes, as
/// far as they decide what is drawn and seen: display, visibility, markers, transform, fill, stroke
/// and opacity.
/// Selectors by type, class, id, attribute, descendant and child, and lists of them (W3C Selectors
/// 3); the cascade with `!important`, specificity and order (W3C CSS 2.1, 6.4). Rules for printers
/// alone, and those with other selectors, are not applied; `unread` names them.
class SvgStyles {
 public:
  /// Keeps references to all elements.
  explicit SvgStyles(const XmlElement& root);

  struct Value {
    std::string text;  ///< empty: nothing says it
    std::string from;  ///< ".st1", "its style", "its attribute"
  };
  /// What holds for one property of an element, without what it inherits.
  Value property(const XmlElement& element, const std::string& name) const;
  /// Selectors and imports that could not be applied.
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  struct Attribute {
    std::string name, value;
    char how = 0;  ///< '=', '~', '^', '$', '*', '|'; 0: it is there
  };
  /// A step of a selector: what one element must be.
  struct Compound {
    std::string type;  ///< empty: any
    std::vector<std::string> ids, classes;
    std::vector<Attribute> attributes;
    bool child = false;  ///< of the step before it, not only somewhere in it
  };
  using Selector = std::vector<Compound>;  ///< the outermost first
  struct Declaration {
    std::string value;
    bool important = false;
  };
  struct Rule {
    Selector selector;
    std::string text;  ///< of the selector
    int specificity = 0;
    std::map<std::string, Declaration> declarations;
  };

  void gather(const XmlElement& element);
  void add_sheet(const std::string& text);
  void add_rules(const std::string& selectors, const std::string& body);
  bool parse(const std::string& text, Selector& selector) const;
  bool parse_compound(const std::string& text, std::size_t& at, Compound& compound) const;
  bool matches(const Compound& compound, const XmlElement& element) const;
  bool matches(const Selector& selector, std::size_t steps, const XmlElement& element) const;
  static std::map<std::string, Declaration> declarations(const std::string& text);

  std::map<const XmlElement*, const XmlElement*> parent_;
  std::vector<Rule> rules_;
  std::vector<std::string> unread_;
};

}  // namespace loosefit::io
