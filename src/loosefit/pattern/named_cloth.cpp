#include "loosefit/pattern/named_cloth.h"

#include <algorithm>

#include "loosefit/pattern/named_edges.h"

namespace loosefit::pattern {

void set_cloth(Pattern& pattern, const NamedCloth& named) {
  for (const std::string& name : named.panels)
    pattern.panels[named_panel(pattern, name)].cloth = named.cloth;
}

PanelCloth cloth_of_layers(double layers, double stiffness) {
  return {layers, stiffness, std::max(1.0, stiffness)};
}

}  // namespace loosefit::pattern
