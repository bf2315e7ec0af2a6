#include "loosefit/pipeline/ease_on_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::pipeline {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The ease of a piece at one of its levels.
struct LevelEase {
  double y = 0, cut = 0, asked = kNan;
};

/// The same part on the wearer's left: what stations are told of.
std::string on_the_left(std::string part) {
  if (const auto at = part.find("_R"); at != std::string::npos) part.replace(at, 2, "_L");
  return part;
}

/// Levels of each part, upwards.
std::map<std::string, std::vector<LevelEase>> levels_of(const CasePattern& pattern) {
  std::map<std::string, std::vector<LevelEase>> levels;
  for (const StationFit& s : pattern.fit_along)
    for (const kinds::StationLine& line : s.lines)
      levels[line.part].push_back({line.y, s.cut(), s.asked.value_or(kNan)});
  for (auto& entry : levels)
    std::sort(entry.second.begin(), entry.second.end(),
              [](const LevelEase& a, const LevelEase& b) { return a.y < b.y; });
  return levels;
}

LevelEase ease_at(const std::vector<LevelEase>& levels, double y) {
  if (y < levels.front().y - kinds::kStationStep || y > levels.back().y + kinds::kStationStep)
    return {y, kNan, kNan};
  const auto above = std::find_if(levels.begin(), levels.end(),
                                  [&](const LevelEase& level) { return level.y >= y; });
  if (above == levels.begin()) return levels.front();
  if (above == levels.end()) return levels.back();
  const LevelEase& below = *(above - 1);
  const double share = (y - below.y) / (above->y - below.y);
  return {y, below.cut + share * (above->cut - below.cut),
          below.asked + share * (above->asked - below.asked)};
}

/// A limb of which stations lie close, and the least radius of the body there [m].
struct CloseLimb {
  std::string place;
  double radius = 0;
};

/// By part, of arms and legs.
std::map<std::string, CloseLimb> close_limbs(const CasePattern& pattern) {
  std::map<std::string, CloseLimb> close;
  for (const StationFit& s : pattern.fit_along) {
    if (s.limb == "trunk" || s.cut() >= kLooseEase) continue;
    const double radius = s.body / (2 * kPi);
    for (const kinds::StationLine& line : s.lines) {
      const auto [entry, first] = close.insert({line.part, {s.place, radius}});
      if (!first && radius < entry->second.radius) entry->second = {s.place, radius};
    }
  }
  return close;
}

/// Edge of the equilateral triangle of the mean flat area of a part's triangles [m]; 0 without any.
double edge_of_part(const garment::Garment& garment, const std::string& part) {
  double area = 0;
  int count = 0;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    if (garment.panel_parts[garment.triangle_panel[t]] == part)
      area += geometry::flat_area(garment.triangle_uv[t]), ++count;
  return count > 0 ? std::sqrt(4 / std::sqrt(3.0) * area / count) : 0;
}

}  // namespace

void set_vertex_ease(garment::GarmentHierarchy& hierarchy, const CasePattern& pattern) {
  const auto levels = levels_of(pattern);
  if (levels.empty()) return;
  for (garment::Garment& mesh : hierarchy.levels) {
    mesh.vertex_ease_cut.assign(static_cast<std::size_t>(mesh.vertex_count), kNan);
    mesh.vertex_ease_asked = mesh.vertex_ease_cut;
    for (int v = 0; v < mesh.vertex_count; ++v) {
      const auto of_part = levels.find(on_the_left(mesh.panel_parts[mesh.vertex_panel[v]]));
      if (of_part == levels.end()) continue;
      const LevelEase here = ease_at(of_part->second, mesh.vertex_uv[v].y());
      mesh.vertex_ease_cut[v] = here.cut;
      mesh.vertex_ease_asked[v] = here.asked;
    }
  }
}

double worn_girth(const garment::Garment& garment, const std::vector<Vec3>& x,
                  const StationFit& station) {
  double girth = 0;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const std::string& part = garment.panel_parts[garment.triangle_panel[t]];
    for (const kinds::StationLine& line : station.lines) {
      if (line.part != part) continue;
      std::vector<Vec3> ends;
      for (int k = 0; k < 3; ++k) {
        const Vec2 &a = garment.triangle_uv[t][k], &b = garment.triangle_uv[t][(k + 1) % 3];
        if ((a.y() < line.y) == (b.y() < line.y)) continue;
        const double share = (line.y - a.y()) / (b.y() - a.y());
        const Vec3 &p = x[garment.triangles[t][k]], &q = x[garment.triangles[t][(k + 1) % 3]];
        ends.push_back(p + share * (q - p));
      }
      if (ends.size() == 2) girth += (ends[1] - ends[0]).norm();
    }
  }
  return girth;
}

std::vector<double> limb_fineness(const CasePattern& pattern, double edge_length) {
  const auto close = close_limbs(pattern);
  std::vector<double> finer;
  for (const pattern::Panel& panel : pattern.pattern.panels) {
    const auto limb = close.find(on_the_left(panel.part));
    finer.push_back(limb == close.end() ? 1.0
                                        : std::clamp(kLimbEdge * limb->second.radius / edge_length,
                                                     kFinestLimb, 1.0));
  }
  return finer;
}

std::vector<std::string> limb_mesh_warnings(const garment::Garment& garment,
                                            const CasePattern& pattern) {
  constexpr double kRounding = 1.2;  // a mesh has edges of about the wanted length
  std::map<std::string, std::pair<double, double>> told;  // place → edge, radius
  for (const auto& [part, limb] : close_limbs(pattern)) {
    const double edge = edge_of_part(garment, part);
    if (edge > kRounding * kLimbEdge * limb.radius) told[limb.place] = {edge, limb.radius};
  }
  std::vector<std::string> lines;
  for (const auto& [place, sizes] : told) {
    const auto& [edge, radius] = sizes;
    lines.push_back(fmt::format(
        "the {} is meshed at {:.0f} mm where its radius is {:.0f} mm: strain round it reads up to "
        "{:.1f} % too large, pressure in proportion; edge_length = {:.3f} holds there",
        place, 1e3 * edge, 1e3 * radius, 100 * edge * edge / (12 * radius * radius),
        kLimbEdge * radius / kFinestLimb));
  }
  return lines;
}

}  // namespace loosefit::pipeline
