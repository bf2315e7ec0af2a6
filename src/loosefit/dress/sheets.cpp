#include "loosefit/dress/sheets.h"

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/dress/flat_layout.h"
#include "loosefit/dress/no_room.h"

namespace loosefit::dress {
namespace {

/// Puts the vertices of a chain evenly along a polyline.
void lay_chain(const garment::Garment::EdgeChain& chain, bool reversed,
               const std::vector<Vec2>& line, std::map<int, Vec2>& outline) {
  double total = 0;
  for (std::size_t i = 1; i < line.size(); ++i) total += (line[i] - line[i - 1]).norm();
  const std::size_t n = chain.vertices.size();
  for (std::size_t k = 0; k < n; ++k) {
    double s = total * double(k) / double(n - 1);
    std::size_t i = 1;
    while (i + 1 < line.size() && s > (line[i] - line[i - 1]).norm()) {
      s -= (line[i] - line[i - 1]).norm();
      ++i;
    }
    const Vec2 direction = (line[i] - line[i - 1]).normalized();
    const int v = chain.vertices[reversed ? n - 1 - k : k];
    outline[v] = line[i - 1] + s * direction;
  }
}

}  // namespace

void PanelOutline::lay(const std::string& edge, const std::string& neighbour,
                       const std::vector<Vec2>& line) {
  const auto* chain = chain_of(edge);
  const auto* first = chain_of(neighbour);
  const int head = chain->vertices.front();
  const bool starts = head == first->vertices.front() || head == first->vertices.back();
  lay_chain(*chain, !starts, line, places_);
}

const garment::Garment::EdgeChain* PanelOutline::chain_of(const std::string& edge) const {
  const auto* chain = garment_.find_part(part_, edge);
  if (!chain || chain->vertices.size() < 2)
    throw GeometryError("pattern: the " + part_ + " of the garment has no edge " + edge);
  return chain;
}

Sheets::Sheets(const garment::Garment& garment)
    : garment_(garment),
      sheets_(garment.vertex_count, 0),
      place_(garment.vertex_count, Vec2::Zero()) {}

void Sheets::add(int panel, const PanelOutline& outline, bool back) {
  const auto layout = lay_flat(garment_, panel, outline.places());
  // Seen from the front the outside of a front panel faces us: counter-clockwise in (x, z).
  if (count_turned_over(garment_, panel, layout, back ? -1 : 1) > 0)
    throw NoRoom("panel " + garment_.panel_names[panel] +
                 " cannot be laid over the body without folding over");
  for (const auto& [v, q] : layout) {
    place_[v] = q;
    sheets_[v] |= back ? 2 : 1;
  }
}

std::vector<Vec3> Sheets::positions(const BodyOutline& depth, const LayingRoom& room) const {
  std::vector<Vec3> x(garment_.vertex_count);
  for (int v = 0; v < garment_.vertex_count; ++v) {
    // A vertex on a seam between front and back lies on the middle surface, others before or
    // behind it.
    const double u = place_[v][0], z = place_[v][1], middle = depth.middle(u, z);
    double y = middle;
    if (sheets_[v] == 1)
      y = std::min(middle + room.depth_share * (depth.front(u, z) - middle),
                   middle - room.least_depth);
    if (sheets_[v] == 2)
      y = std::max(middle + room.depth_share * (depth.back(u, z) - middle),
                   middle + room.least_depth);
    x[v] = Vec3(u, y, z);
  }
  return x;
}

}  // namespace loosefit::dress
