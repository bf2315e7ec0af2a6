#include "loosefit/io/svg/svg_style.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <tuple>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostRules = 2000, kMostSteps = 8;
constexpr const char* kDecisive[] = {"display",      "visibility", "marker",
                                     "marker-start", "marker-end", "transform"};
/// What paints a line decides nothing: unseen lines are told.
constexpr const char* kPaint[] = {"fill",         "stroke",         "opacity",
                                  "fill-opacity", "stroke-opacity", "stroke-width"};
constexpr std::size_t kMostPaintRules = 500;

bool is_paint(const std::string& name) {
  return std::find(std::begin(kPaint), std::end(kPaint), name) != std::end(kPaint);
}

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string trimmed(const std::string& text) {
  std::size_t from = 0, to = text.size();
  while (from < to && is_space(text[from])) ++from;
  while (to > from && is_space(text[to - 1])) --to;
  return text.substr(from, to - from);
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string without_comments(const std::string& text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find("/*", at), text.size());
    plain += text.substr(at, open - at);
    const std::size_t close = text.find("*/", open + 2);
    at = close == std::string::npos ? text.size() : close + 2;
  }
  // Old pages hide their sheets in comments of HTML.
  for (const char* mark : {"<!--", "-->"})
    while (plain.find(mark) != std::string::npos)
      plain.replace(plain.find(mark), std::string(mark).size(), " ");
  return plain;
}

bool in_a_name(char c) {
  const unsigned char u = static_cast<unsigned char>(c);
  return std::isalnum(u) || c == '-' || c == '_' || u >= 0x80;
}

/// A name of CSS, in which a backslash takes what follows as it is; empty without one.
std::string name_at(const std::string& text, std::size_t& at) {
  std::string name;
  while (at < text.size()) {
    if (text[at] == '\\' && at + 1 < text.size()) {
      name += text[at + 1];
      at += 2;
    } else if (in_a_name(text[at])) {
      name += text[at++];
    } else {
      break;
    }
  }
  return name;
}

bool has_word(const std::string& text, const std::string& wanted) {
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (word == wanted) return true;
  return false;
}

/// Of @media and of a sheet: whether it holds on a screen.
bool for_screens(const std::string& media) {
  const std::string words = lower(media);
  return trimmed(words).empty() || words.find("all") != std::string::npos ||
         words.find("screen") != std::string::npos || words.find("print") == std::string::npos;
}

/// Index behind the brace that closes the one at `open`.
std::size_t behind_block(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '{';
    depth -= text[i] == '}';
    if (depth == 0) return i + 1;
  }
  return text.size();
}

}  // namespace

SvgStyles::SvgStyles(const XmlElement& root) { gather(root); }

void SvgStyles::gather(const XmlElement& element) {
  const std::string& type = element.attribute("type");
  if (element.name == "style" && (type.empty() || lower(type) == "text/css") &&
      for_screens(element.attribute("media")))
    add_sheet(without_comments(element.text));
  for (const XmlElement& child : element.children) {
    parent_[&child] = &element;
    gather(child);
  }
}

void SvgStyles::add_sheet(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find('{', at), text.size());
    const std::size_t line = std::min(text.find(';', at), text.size());
    const std::string head = trimmed(text.substr(at, std::min(open, line) - at));
    if (head.starts_with("@") && line < open) {  // @import, @charset, @namespace
      if (head.starts_with("@import")) unread_.push_back(printable(head));
      at = line + 1;
      continue;
    }
    if (open == text.size()) break;
    const std::size_t end = behind_block(text, open);
    const std::string body = text.substr(open + 1, end - open - 2);
    if (!head.starts_with("@"))
      add_rules(trimmed(text.substr(at, open - at)), body);
    else if (head.starts_with("@media") && for_screens(head.substr(6)))
      add_sheet(body);
    at = end;
  }
}

void SvgStyles::add_rules(const std::string& selectors, const std::string& body) {
  std::map<std::string, Declaration> all = declarations(body);
  const bool paint =
      std::all_of(all.begin(), all.end(), [](const auto& one) { return is_paint(one.first); });
  if (all.empty() || (paint && rules_.size() >= kMostPaintRules)) return;
  std::istringstream list(selectors);
  for (std::string one; std::getline(list, one, ',');) {
    Rule rule;
    rule.text = trimmed(one);
    rule.declarations = all;
    if (rules_.size() >= kMostRules || !parse(rule.text, rule.selector)) {
      if (!paint) unread_.push_back("selector " + printable(rule.text));
      continue;
    }
    for (const Compound& step : rule.selector)
      rule.specificity += static_cast<int>(10'000 * step.ids.size() +
                                           100 * (step.classes.size() + step.attributes.size())) +
                          !step.type.empty();
    rules_.push_back(std::move(rule));
  }
}

std::map<std::string, SvgStyles::Declaration> SvgStyles::declarations(const std::string& text) {
  std::map<std::string, Declaration> found;
  std::istringstream all(text);
  for (std::string one; std::getline(all, one, ';');) {
    const std::size_t colon = one.find(':');
    if (colon == std::string::npos) continue;
    const std::string name = lower(trimmed(one.substr(0, colon)));
    if (std::find(std::begin(kDecisive), std::end(kDecisive), name) == std::end(kDecisive) &&
        !is_paint(name))
      continue;
    Declaration declaration{trimmed(one.substr(colon + 1)), false};
    if (const std::size_t mark = declaration.value.find('!'); mark != std::string::npos) {
      declaration.important = lower(declaration.value).find("important") != std::string::npos;
      declaration.value = trimmed(declaration.value.substr(0, mark));
    }
    // The short form sets both ends.
    if (name == "marker") found["marker-start"] = found["marker-end"] = declaration;
    found[name] = std::move(declaration);
  }
  return found;
}

bool SvgStyles::parse_compound(const std::string& text, std::size_t& at, Compound& step) const {
  const std::size_t start = at;
  if (at < text.size() && text[at] == '*')
    ++at;
  else
    step.type = name_at(text, at);
  while (at < text.size() && !is_space(text[at]) && text[at] != '>') {
    const char mark = text[at++];
    if (mark == '.' || mark == '#') {
      const std::string name = name_at(text, at);
      if (name.empty()) return false;
      (mark == '.' ? step.classes : step.ids).push_back(name);
      continue;
    }
    const std::size_t end = text.find(']', at);
    if (mark != '[' || end == std::string::npos) return false;
    Attribute attribute;
    std::string inside = text.substr(at, end - at);
    at = end + 1;
    if (const std::size_t equal = inside.find('='); equal != std::string::npos) {
      attribute.value = trimmed(inside.substr(equal + 1));
      if (attribute.value.size() > 1 && (attribute.value[0] == '"' || attribute.value[0] == '\''))
        attribute.value = attribute.value.substr(1, attribute.value.size() - 2);
      attribute.how = '=';
      inside.resize(equal);
      if (!inside.empty() && std::string("~^$*|").find(inside.back()) != std::string::npos) {
        attribute.how = inside.back();
        inside.pop_back();
      }
    }
    for (const char c : trimmed(inside))
      if (c != '\\') attribute.name += c;
    if (attribute.name.empty() || attribute.how == '|') return false;
    step.attributes.push_back(std::move(attribute));
  }
  return at > start;
}

bool SvgStyles::parse(const std::string& text, Selector& selector) const {
  bool child = false;
  for (std::size_t at = 0; at < text.size();) {
    if (is_space(text[at])) {
      ++at;
    } else if (text[at] == '>') {
      if (selector.empty() || child) return false;
      child = true;
      ++at;
    } else {
      Compound step;
      if (!parse_compound(text, at, step)) return false;
      step.child = child;
      child = false;
      selector.push_back(std::move(step));
    }
  }
  return !selector.empty() && selector.size() <= kMostSteps && !child;
}

bool SvgStyles::matches(const Compound& step, const XmlElement& e) const {
  if (!step.type.empty() && step.type != e.name) return false;
  for (const std::string& id : step.ids)
    if (e.attribute("id") != id) return false;
  for (const std::string& name : step.classes)
    if (!has_word(e.attribute("class"), name)) return false;
  return std::all_of(step.attributes.begin(), step.attributes.end(), [&](const Attribute& a) {
    const auto found = e.attributes.find(a.name);
    if (found == e.attributes.end()) return false;
    const std::string& value = found->second;
    switch (a.how) {
      case '=':
        return value == a.value;
      case '~':
        return has_word(value, a.value);
      case '^':
        return !a.value.empty() && value.starts_with(a.value);
      case '$':
        return !a.value.empty() && value.ends_with(a.value);
      case '*':
        return !a.value.empty() && value.find(a.value) != std::string::npos;
      default:
        return true;
    }
  });
}

bool SvgStyles::matches(const Selector& selector, std::size_t steps, const XmlElement& e) const {
  if (!matches(selector[steps - 1], e)) return false;
  if (steps == 1) return true;
  for (auto at = parent_.find(&e); at != parent_.end(); at = parent_.find(at->second)) {
    if (matches(selector, steps - 1, *at->second)) return true;
    if (selector[steps - 1].child) return false;
  }
  return false;
}

SvgStyles::Value SvgStyles::property(const XmlElement& element, const std::string& name) const {
  // Important before others, then the style attribute, then by specificity; later ones win ties.
  using Weight = std::tuple<bool, bool, int>;
  Value best{element.attribute(name), "its attribute"};
  Weight weight{false, false, -1};
  for (const Rule& rule : rules_) {
    const auto found = rule.declarations.find(name);
    if (found == rule.declarations.end()) continue;
    const Weight its{found->second.important, false, rule.specificity};
    if (its < weight || !matches(rule.selector, rule.selector.size(), element)) continue;
    weight = its;
    best = {found->second.value, rule.text};
  }
  const std::map<std::string, Declaration> own = declarations(element.attribute("style"));
  if (const auto found = own.find(name); found != own.end())
    if (Weight{found->second.important, true, 0} > weight)
      best = {found->second.value, "its style"};
  return best;
}

}  // namespace loosefit::io
