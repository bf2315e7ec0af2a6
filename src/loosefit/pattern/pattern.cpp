#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

int Pattern::find_panel(const std::string& panel_name) const {
  for (std::size_t p = 0; p < panels.size(); ++p)
    if (panels[p].name == panel_name) return static_cast<int>(p);
  return -1;
}

int Pattern::find_part(const std::string& part) const {
  for (std::size_t p = 0; p < panels.size(); ++p)
    if (panels[p].part == part) return static_cast<int>(p);
  return -1;
}

}  // namespace loosefit::pattern
