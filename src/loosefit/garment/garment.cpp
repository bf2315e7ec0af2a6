#include "loosefit/garment/garment.h"

namespace loosefit::garment {

const Garment::EdgeChain* Garment::find_chain(const std::string& panel,
                                              const std::string& edge) const {
  for (const EdgeChain& chain : edge_chains)
    if (chain.name == edge && panel_names[chain.panel] == panel) return &chain;
  return nullptr;
}

const Garment::EdgeChain* Garment::find_part(const std::string& panel,
                                             const std::string& edge) const {
  for (const EdgeChain& chain : edge_chains)
    if (chain.part == edge && chain.panel < static_cast<int>(panel_parts.size()) &&
        panel_parts[chain.panel] == panel)
      return &chain;
  return nullptr;
}

}  // namespace loosefit::garment
