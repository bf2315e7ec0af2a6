#pragma once
#include <string>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/fabric/band_energy.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::garment {

/// Sewn triangle mesh that remembers its pattern. Seams are welded: the two sides of a seam share
/// vertices, so a vertex may have one pattern position per panel. Topology never changes after
/// assembly; positions live elsewhere (Drape).
struct Garment {
  int vertex_count = 0;
  std::vector<Triangle> triangles;  ///< wound so that the normal points outside
  std::vector<std::array<Vec2, 3>>
      triangle_uv;                  ///< pattern coordinates of the corners [m]: u weft, v warp
  std::vector<int> triangle_panel;  ///< index into panel_names
  std::vector<std::string> panel_names;
  std::vector<std::string> panel_parts;  ///< Panel::part of each; empty: of no draft
  std::vector<int> vertex_panel;         ///< lowest panel index touching the vertex
  std::vector<Vec2> vertex_uv;           ///< pattern position in that panel [m]

  std::vector<double> vertex_mass;  ///< lumped: fabric, attachments, seams [kg]
  /// Share of vertex_mass that belongs to attachments [kg]; empty: there are none.
  std::vector<double> vertex_attached_mass;
  std::vector<double>
      triangle_membrane_factor;                ///< in-plane stiffness multiplier (1 = plain fabric)
  std::vector<double> triangle_added_bending;  ///< isotropic rigidity added by attachments [N m]

  /// What pulls along paths; their triangles are those of the garment.
  std::vector<fabric::BandPart> bands;

  /// Ease at each vertex' level, girth of the flat pieces over girth of the body − 1, as cut and as
  /// asked for [–]; NaN where it is not known; empty: nowhere.
  std::vector<double> vertex_ease_cut, vertex_ease_asked;

  /// A rigid board on a level. Its triangles stay in one plane; its outline is edges of the mesh
  /// where the mesh could follow it.
  struct RigidBoard {
    std::string name;
    std::vector<int> triangles;      ///< ascending
    std::vector<int> vertices;       ///< of these triangles, ascending
    std::array<int, 3> leaders{};    ///< three of them that lie far apart
    std::array<Vec2, 3> leader_uv{};  ///< [m], counter-clockwise as the triangles are
    std::vector<Vec3> weights;       ///< of each vertex: barycentric in the leaders
    double area = 0;                 ///< flat [m²]
    double mass = 0;                 ///< [kg], of the board alone
    double offset = 0;     ///< of its centre of mass from the cloth, along the outside normal [m]
  };
  std::vector<RigidBoard> rigid_boards;  ///< no vertex is in two of them
  /// Thickness that parts on its inside put between the triangle and what is under it [m]; empty:
  /// there are none.
  std::vector<double> triangle_padding;

  std::vector<char> triangle_built_in;  ///< held in a rigid clamp; empty: none

  /// Vertices along a panel edge in outline order, ends included.
  struct EdgeChain {
    int panel = 0;
    int edge = 0;      ///< index into Panel::edges
    std::string name;  ///< PanelEdge::name
    std::string part;  ///< PanelEdge::part
    std::vector<int> vertices;
  };
  std::vector<EdgeChain> edge_chains;  ///< every edge of every panel

  double area = 0;  ///< flat area [m²]
  double mass = 0;  ///< with attachments [kg]

  /// Mass of one vertex without attachments [kg].
  double cloth_mass(int vertex) const {
    return vertex_mass[vertex] - (vertex_attached_mass.empty() ? 0 : vertex_attached_mass[vertex]);
  }

  /// Chain of `panel`/`edge` by name; nullptr if there is none.
  const EdgeChain* find_chain(const std::string& panel, const std::string& edge) const;
  /// The same by what panel and edge are in the draft (Panel::part), whatever they are called.
  const EdgeChain* find_part(const std::string& panel, const std::string& edge) const;
};

}  // namespace loosefit::garment
