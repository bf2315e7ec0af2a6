#include "loosefit/garment/assemble.h"

#include "loosefit/garment/attach.h"
#include "loosefit/garment/sew_panels.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/mesher.h"

namespace loosefit {

Garment assemble(const Pattern& pattern, double edge_length, const Material& material,
                 const std::vector<Attachment>& attachments) {
  const std::vector<std::vector<int>> divisions = edge_divisions(pattern, edge_length);
  std::vector<PanelMesh> meshes;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p)
    meshes.push_back(mesh_panel(pattern.panels[p], divisions[p], edge_length));
  Garment garment = sew_panels(pattern, meshes, material).garment;
  attach(garment, pattern, attachments);
  return garment;
}

}  // namespace loosefit
