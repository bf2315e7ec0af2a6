#include "loosefit/drape/rims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/drape/hood_seam.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::drape {
namespace {

constexpr double kSoft = 0.99;    ///< of the fabric's stiffness, below which an edge is softer
constexpr double kRunsIn = 0.05;  ///< of a rim, from which on it runs along warp or weft

std::string name_of(const Opening& o, const std::string& piece) {
  using kinds::OpeningUse;
  switch (o.use) {
    case OpeningUse::neck:
      return "the neck";
    case OpeningUse::left_arm:
      return "the left cuff or armhole";
    case OpeningUse::right_arm:
      return "the right cuff or armhole";
    case OpeningUse::left_leg:
      return "the hem of the left leg";
    case OpeningUse::right_leg:
      return "the hem of the right leg";
    case OpeningUse::waist:
      return "the waist";
    case OpeningUse::upper:
      return o.at_chest ? "the upper edge" : "the waist";
    case OpeningUse::hem:
    case OpeningUse::cape_hem:
      return "the hem";
    case OpeningUse::limb:
      return std::string("the opening for ") + round_what(o.round);
    case OpeningUse::tube:
    case OpeningUse::unknown:
      break;
  }
  return fmt::format("the opening of {:.2f} m at {}", o.girth, printable(piece));
}

/// Finds the rims of one garment.
class RimFinder {
 public:
  explicit RimFinder(const garment::Garment& garment)
      : garment_(garment), topology_(garment.triangles) {}

  Rim rim(const Opening& opening, const std::vector<Opening>& all) const {
    Rim rim{.opening = opening,
            .name = name_of(
                opening,
                garment_.panel_names[std::size_t(garment_.vertex_panel[opening.loop.front()])]),
            .parts = {}};
    std::set<int> at_edge;
    bool soft = true, hood = opening.use == kinds::OpeningUse::neck;
    for (const int triangle : triangles_along(opening.loop)) {
      const int panel = garment_.triangle_panel[triangle];
      at_edge.insert(panel);
      soft = soft && !garment_.triangle_membrane_factor.empty() &&
             garment_.triangle_membrane_factor[triangle] < kSoft;
      hood = hood && pattern::words_of(garment_.panel_names[panel]).hood;
    }
    if (soft || hood)
      if (const std::vector<int> seam = hood_seam(garment_, all, opening); !seam.empty())
        rim.parts = parts_along(seam, at_edge);
    if (rim.parts.empty()) rim.parts = parts_along(opening.loop, {});
    return rim;
  }

 private:
  std::vector<int> triangles_along(const std::vector<int>& loop) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (const int e = topology_.find(loop[i], loop[(i + 1) % loop.size()]); e >= 0)
        found.push_back(topology_.sides(e)[0].triangle);
    return found;
  }

  /// Of a chain of vertices, closed where its ends share an edge, as on a panel that is none of
  /// `without`.
  std::vector<Rim::Part> parts_along(const std::vector<int>& chain,
                                     const std::set<int>& without) const {
    std::vector<Rim::Part> parts;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const int e = topology_.find(chain[i], chain[(i + 1) % chain.size()]);
      if (e < 0) continue;
      const auto sides = topology_.sides(e);
      const auto side = std::ranges::find_if(sides, [&](const auto& s) {
        return !without.contains(garment_.triangle_panel[s.triangle]);
      });
      const auto& [t, corner] = side == sides.end() ? sides.front() : *side;
      const auto& uv = garment_.triangle_uv[t];
      const Triangle& vertices = garment_.triangles[t];
      const int next = (corner + 1) % 3;
      parts.push_back({vertices[corner], vertices[next], uv[next] - uv[corner]});
    }
    return parts;
  }

  const garment::Garment& garment_;
  geometry::MeshTopology topology_;
};

}  // namespace

double borne_strain(double valid, double stretch) {
  const double stated = std::max(valid, stretch);
  return stated > 0 ? std::max(stated, kTears) : 0;
}

double Rim::cut() const { return stretched(0, 0, 0); }

double Rim::stretched(double warp, double weft, double shear) const {
  double sum = 0;
  for (const Part& p : parts) {
    const double a = (1 + weft) * std::abs(p.way.x()), b = (1 + warp) * std::abs(p.way.y());
    sum += std::sqrt(a * a + b * b + 2 * a * b * std::sin(shear));
  }
  return sum;
}

double Rim::opened(const fabric::Material& material) const {
  return stretched(material.gives_warp(), material.gives_weft(), material.valid_shear);
}

double Rim::borne(const fabric::Material& m) const {
  return stretched(borne_strain(m.valid_strain_warp, m.stretch_warp),
                   borne_strain(m.valid_strain_weft, m.stretch_weft), m.valid_shear);
}

bool Rim::is_stated(const fabric::Material& material) const {
  double along_weft = 0, along_warp = 0;
  for (const Part& p : parts) along_weft += std::abs(p.way.x()), along_warp += std::abs(p.way.y());
  const double least = kRunsIn * cut();
  return (along_weft <= least || material.gives_weft() > 0) &&
         (along_warp <= least || material.gives_warp() > 0);
}

double Rim::length(const std::vector<Vec3>& x) const {
  double sum = 0;
  for (const Part& p : parts) sum += (x[p.to] - x[p.from]).norm();
  return sum;
}

std::vector<Rim> garment_rims(const garment::Garment& garment, const pattern::Pattern& pattern,
                              const body::PosedBody& body) {
  const std::vector<Opening> openings = garment_openings(garment, pattern, body);
  const RimFinder finder(garment);
  std::vector<Rim> rims;
  for (const Opening& opening : openings) rims.push_back(finder.rim(opening, openings));
  return rims;
}

std::vector<std::string> overstretched_rims(const std::vector<Rim>& rims,
                                            const std::vector<Vec3>& x,
                                            const fabric::Material& material) {
  std::vector<std::string> found;
  for (const Rim& rim : rims) {
    const double now = rim.length(x), most = rim.borne(material);
    if (!rim.is_stated(material) || now <= most) continue;
    found.push_back(fmt::format(
        "{} is stretched to {:.3f} m, {:.3f} m as cut, where {} bears no more than {:.3f} m: it "
        "would tear there, or nobody would get into it",
        rim.name, now, rim.cut(), printable(material.name), most));
  }
  return found;
}

}  // namespace loosefit::drape
