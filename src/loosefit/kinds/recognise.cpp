#include "loosefit/kinds/recognise.h"

#include "loosefit/kinds/registry.h"

namespace loosefit::kinds {
namespace {

/// Whether all pieces and edges are called as the draft calls its parts.
bool called_like_parts(const pattern::Pattern& pattern) {
  for (const pattern::Panel& panel : pattern.panels) {
    if (panel.part.empty() || panel.name != panel.part) return false;
    for (const pattern::PanelEdge& edge : panel.edges)
      if (edge.name != edge.part) return false;
  }
  return true;
}

bool same_parts(const pattern::Pattern& a, const pattern::Pattern& b) {
  for (std::size_t p = 0; p < a.panels.size(); ++p) {
    if (a.panels[p].part != b.panels[p].part) return false;
    for (std::size_t e = 0; e < a.panels[p].edges.size(); ++e)
      if (a.panels[p].edges[e].part != b.panels[p].edges[e].part) return false;
  }
  return true;
}

}  // namespace

Recognised recognise_kind(pattern::Pattern& pattern, const std::string& mark) {
  bool known = false;
  for (const GarmentKind& kind : garment_kinds()) {
    if (!mark.empty() && kind.mark != mark) continue;
    known = true;
    pattern::Pattern noted = pattern;
    if (!kind.note_parts(noted) || (mark.empty() && !called_like_parts(noted))) continue;
    pattern = std::move(noted);
    pattern.kind = kind.name;
    return Recognised::yes;
  }
  if (mark.empty()) return Recognised::no;
  return known ? Recognised::sewn_otherwise : Recognised::unknown_draft;
}

std::string draft_mark(const pattern::Pattern& pattern) {
  const GarmentKind& kind = garment_kind(pattern.kind);
  pattern::Pattern noted = pattern;
  return kind.note_parts(noted) && same_parts(noted, pattern) ? kind.mark : std::string();
}

}  // namespace loosefit::kinds
