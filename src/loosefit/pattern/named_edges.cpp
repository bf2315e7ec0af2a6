#include "loosefit/pattern/named_edges.h"

#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {
namespace {

/// `said` is what the error has found.
int find_panel_or_fail(const Pattern& pattern, const std::string& name, const std::string& said) {
  const int p = pattern.find_panel(name);
  if (p >= 0) return p;
  std::vector<std::string> names;
  for (const Panel& panel : pattern.panels) names.push_back(panel.name);
  throw InvalidInput({}, "\"" + printable(said) + "\"", "a panel of the pattern",
                     did_you_mean(name, names));
}

}  // namespace

int named_panel(const Pattern& pattern, const std::string& name) {
  return find_panel_or_fail(pattern, name, name);
}

Stitch::Side named_edge(const Pattern& pattern, const std::string& name) {
  const auto fail = [&](const std::string& expected, const std::string& hint = {}) {
    return InvalidInput({}, "\"" + printable(name) + "\"", expected, hint);
  };
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) throw fail("a panel and an edge, \"FRONT.e1\"");
  const std::string panel_name = name.substr(0, dot), edge_name = name.substr(dot + 1);
  const int p = find_panel_or_fail(pattern, panel_name, name);
  const Panel& panel = pattern.panels[p];
  std::vector<std::string> names;
  for (const PanelEdge& edge : panel.edges) names.push_back(edge.name);
  const int e = find_edge(panel, edge_name);
  if (e < 0)
    throw fail("an edge of panel " + printable(panel.name), did_you_mean(edge_name, names));
  return {p, e};
}

void add_elastic(Pattern& pattern, const NamedElastic& named) {
  for (const std::string& name : named.edges) {
    const auto [p, e] = named_edge(pattern, name);
    auto& elastic = pattern.panels[p].edges[e].elastic;
    if (elastic)
      throw InvalidInput({}, "\"" + printable(name) + "\"", "an edge that has no elastic yet",
                         "each edge takes one");
    elastic = named.elastic;
  }
}

}  // namespace loosefit::pattern
