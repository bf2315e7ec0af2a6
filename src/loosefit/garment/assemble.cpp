#include "loosefit/garment/assemble.h"

#include "loosefit/garment/attach.h"
#include "loosefit/garment/board_shape.h"
#include "loosefit/garment/sew_panels.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/mesher.h"

namespace loosefit::garment {

Garment assemble(const pattern::Pattern& pattern, double edge_length,
                 const fabric::Material& material, const std::vector<Attachment>& attachments) {
  const std::vector<std::vector<int>> divisions = pattern::edge_divisions(pattern, edge_length);
  std::vector<pattern::PanelMesh> meshes;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p)
    meshes.push_back(
        pattern::mesh_panel(pattern.panels[p], divisions[p], edge_length,
                            board_insets(pattern.panels[p].name, attachments, edge_length, 0)));
  Garment garment = sew_panels(pattern, meshes, material).garment;
  attach(garment, pattern, attachments, material);
  return garment;
}

}  // namespace loosefit::garment
