#include "loosefit/garment/hierarchy.h"

#include "loosefit/garment/attach.h"
#include "loosefit/garment/board_shape.h"
#include "loosefit/garment/sew_panels.h"
#include "loosefit/pattern/divisions.h"
#include "loosefit/pattern/mesher.h"

namespace loosefit::garment {
namespace {

constexpr double kCoarsestEdge = 0.018;  // coarsest edge is in [this, twice this) [m]
constexpr int kMostRefinements = 8;

}  // namespace

int hierarchy_refinements(double edge_length) {
  int refinements = 0;
  for (double edge = edge_length; edge < kCoarsestEdge && refinements < kMostRefinements; edge *= 2)
    ++refinements;
  return refinements;
}

namespace {

/// The first `levels` of the hierarchy, at least one.
GarmentHierarchy build_levels(const pattern::Pattern& pattern, double edge_length,
                              const fabric::Material& material,
                              const std::vector<Attachment>& attachments,
                              const std::vector<double>& fineness, int levels) {
  const auto edges = [&](double length) {
    std::vector<double> of_panels(pattern.panels.size(), length);
    for (std::size_t p = 0; p < fineness.size(); ++p) of_panels[p] *= fineness[p];
    return of_panels;
  };
  // Impossible edge lengths are refused before the work starts.
  pattern::edge_divisions(pattern, edges(edge_length));
  const int refinements = hierarchy_refinements(edge_length);
  const double coarsest = edge_length * (1 << refinements);
  const std::vector<double> coarsest_of = edges(coarsest);
  const std::vector<std::vector<int>> divisions = pattern::edge_divisions(pattern, coarsest_of);

  // The coarsest level is meshed; every finer one is a subdivision of the one before.
  GarmentHierarchy hierarchy;
  hierarchy.pattern = pattern;
  std::vector<pattern::PanelMesh> meshes;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p)
    meshes.push_back(pattern::mesh_panel(
        pattern.panels[p], divisions[p], coarsest_of[p],
        board_insets(pattern.panels[p].name, attachments, edges(edge_length)[p], refinements)));
  SewnPanels sewn = sew_panels(pattern, meshes, material);
  hierarchy.parents.push_back({});
  for (int v = 0; v < sewn.garment.vertex_count; ++v) hierarchy.parents[0].push_back({v, v});

  for (int level = 0;; ++level) {
    attach(sewn.garment, pattern, attachments, material);
    hierarchy.levels.push_back(sewn.garment);
    if (level + 1 == levels) return hierarchy;

    // Subdivide the panels and sew them again; old vertices keep their numbers.
    std::vector<std::vector<std::array<int, 2>>> local(pattern.panels.size());
    for (std::size_t p = 0; p < pattern.panels.size(); ++p)
      meshes[p] = pattern::subdivide(meshes[p], pattern.panels[p], local[p]);
    SewnPanels finer = sew_panels(pattern, meshes, material, &sewn.vertex_of);
    // Parents of the panels' vertices in the numbers of the garment.
    std::vector<std::array<int, 2>> parents(finer.garment.vertex_count);
    for (std::size_t p = 0; p < local.size(); ++p)
      for (std::size_t i = 0; i < local[p].size(); ++i) {
        const auto [a, b] = local[p][i];
        parents[finer.vertex_of[p][i]] = {sewn.vertex_of[p][a], sewn.vertex_of[p][b]};
      }
    hierarchy.parents.push_back(parents);
    sewn = std::move(finer);
  }
}

}  // namespace

GarmentHierarchy build_hierarchy(const pattern::Pattern& pattern, double edge_length,
                                 const fabric::Material& material,
                                 const std::vector<Attachment>& attachments,
                                 const std::vector<double>& finer) {
  return build_levels(pattern, edge_length, material, attachments, finer,
                      hierarchy_refinements(edge_length) + 1);
}

GarmentHierarchy build_coarsest_level(const pattern::Pattern& pattern, double edge_length,
                                      const fabric::Material& material,
                                      const std::vector<Attachment>& attachments,
                                      const std::vector<double>& finer) {
  return build_levels(pattern, edge_length, material, attachments, finer, 1);
}

}  // namespace loosefit::garment
