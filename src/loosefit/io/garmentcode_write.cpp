#include "loosefit/io/garmentcode_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"
#include "loosefit/io/garmentcode_frame.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPerMetre = 100;  // centimetres
constexpr double kSameCut = 1e-7;  // of the arc length

/// One file edge: a single curve.
struct Part {
  Vec2 start, end;
  pattern::EdgeCurve curve;
};

/// Rounding noise of the unit change would print as 25.919999999999998.
double tidy(double x) { return std::round(x * 1e9) / 1e9 + 0.0; }

/// Of a chord; coarser than what reading and writing again changes.
double tidy_share(double x) { return std::round(x * 1e12) / 1e12 + 0.0; }

void add_cuts(std::vector<double>& cuts, const std::vector<double>& more) {
  for (const double f : more)
    if (std::none_of(cuts.begin(), cuts.end(),
                     [f](double known) { return std::abs(known - f) < kSameCut; }))
      cuts.push_back(f);
  std::sort(cuts.begin(), cuts.end());
}

/// The edge cut at its own joints and at `cuts` (fractions of its arc length).
std::vector<Part> parts_of(const pattern::EdgePath& path, const std::vector<double>& cuts) {
  std::vector<Part> parts;
  std::vector<std::vector<double>> inner(path.curves().size());
  const std::vector<double> joints = path.joint_fractions();
  for (const double f : cuts) {
    const bool joint = std::any_of(joints.begin(), joints.end(),
                                   [f](double known) { return std::abs(known - f) < kSameCut; });
    if (joint || f < kSameCut || f > 1 - kSameCut) continue;
    const auto [c, t] = path.locate(f);
    inner[c].push_back(t);
  }
  for (std::size_t c = 0; c < path.curves().size(); ++c) {
    pattern::EdgeCurve rest = path.curves()[c];
    Vec2 from = path.knot(static_cast<int>(c));
    const Vec2 to = path.knot(static_cast<int>(c) + 1);
    double done = 0;
    for (const double t : inner[c]) {
      const double local = (t - done) / (1 - done);
      const Vec2 middle = pattern::curve_point(rest, from, to, local);
      const auto [left, right] = pattern::split_curve(rest, from, to, local);
      parts.push_back({from, middle, left});
      from = middle;
      rest = right;
      done = t;
    }
    parts.push_back({from, to, rest});
  }
  return parts;
}

Json curvature_of(const Part& part, const std::string& where) {
  const Vec2 chord = part.end - part.start;
  const double squared = chord.squaredNorm();
  if (!(squared > 1e-16))
    throw GeometryError(InputPlace{{}, 0, where}, "a curve that ends where it starts",
                        "different end points");
  const auto relative = [&](const Vec2& p) {
    const Vec2 d = p - part.start;
    const double along = d.dot(chord) / squared,
                 across = (chord.x() * d.y() - chord.y() * d.x()) / squared;
    return Json::array({tidy_share(along), tidy_share(across)});
  };
  Json params = Json::array();
  if (part.curve.kind == pattern::EdgeCurve::Kind::circle) {
    params = {tidy(part.curve.radius * kPerMetre), part.curve.large_arc ? 1 : 0,
              part.curve.sweep ? 1 : 0};
    return {{"type", "circle"}, {"params", params}};
  }
  for (const Vec2& c : part.curve.control) params.push_back(relative(c));
  return {{"type", part.curve.kind == pattern::EdgeCurve::Kind::quadratic ? "quadratic" : "cubic"},
          {"params", params}};
}

/// A line with what a piece is made of; nothing for one layer of the fabric.
std::string cloth_line(const pattern::PanelCloth& cloth) {
  if (cloth == pattern::PanelCloth{}) return {};
  const Json values = {
      {"mass", cloth.mass}, {"membrane", cloth.membrane}, {"bending", cloth.bending}};
  return fmt::format("        \"{}\": {},\n", kClothKey, values.dump());
}

/// A line with the holes of a piece; nothing without any.
std::string holes_line(const std::vector<pattern::PanelHole>& holes) {
  if (holes.empty()) return {};
  Json list = Json::array();
  for (const pattern::PanelHole& hole : holes) {
    Json points = Json::array();
    for (const Vec2& p : hole.points)
      points.push_back(Json::array({tidy(p.x() * kPerMetre), tidy(p.y() * kPerMetre)}));
    list.push_back({{"name", hole.name}, {"points", points}});
  }
  return fmt::format("        \"{}\": {},\n", kHolesKey, list.dump());
}

Json numbers(const Vec3& v) { return Json::array({tidy(v.x()), tidy(v.y()), tidy(v.z())}); }

std::string list_lines(const std::vector<Json>& items, const std::string& indent) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i ? ",\n" : "\n") + indent + "  " + items[i].dump();
  return text + (items.empty() ? "]" : "\n" + indent + "]");
}

}  // namespace

std::string garmentcode_text(const pattern::Pattern& pattern) {
  pattern::check_pattern(pattern);
  // Each edge is cut at its own joints, and at those of the edge it is sewn to.
  std::vector<std::vector<pattern::EdgePath>> paths;
  std::vector<std::vector<std::vector<double>>> cuts;  // [panel][edge]
  for (const pattern::Panel& panel : pattern.panels) {
    paths.emplace_back();
    cuts.emplace_back();
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      paths.back().emplace_back(panel, static_cast<int>(e));
      cuts.back().push_back(paths.back().back().joint_fractions());
    }
  }
  for (const pattern::Stitch& s : pattern.stitches) {
    auto& a = cuts[s.first.panel][s.first.edge];
    auto& b = cuts[s.second.panel][s.second.edge];
    const auto across = [&](std::vector<double> fractions) {
      if (!s.right_wrong)
        for (double& f : fractions) f = 1 - f;
      return fractions;
    };
    add_cuts(a, across(b));
    b = across(a);
    std::sort(b.begin(), b.end());
  }

  // Panels: one file edge per curve; range[panel][edge] remembers which file edges an edge became.
  std::string panels;
  std::vector<std::vector<std::pair<int, int>>> range(pattern.panels.size());  // first, count
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const pattern::Panel& panel = pattern.panels[p];
    std::vector<Json> vertices, edges;
    std::vector<std::pair<Part, const pattern::PanelEdge*>> parts;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      const std::vector<Part> pieces = parts_of(paths[p][e], cuts[p][e]);
      range[p].push_back({static_cast<int>(parts.size()), static_cast<int>(pieces.size())});
      for (const Part& piece : pieces) parts.push_back({piece, &panel.edges[e]});
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto& [part, edge] = parts[i];
      vertices.push_back(
          Json::array({tidy(part.start.x() * kPerMetre), tidy(part.start.y() * kPerMetre)}));
      Json item = {{"endpoints", Json::array({i, (i + 1) % parts.size()})}};
      if (part.curve.kind != pattern::EdgeCurve::Kind::line)
        item["curvature"] = curvature_of(part, "panel " + panel.name + " edge " + edge->name);
      if (!edge->label.empty()) item["label"] = edge->label;
      item["name"] = edge->name;
      if (edge->finish > 0) item[kFinishKey] = tidy(edge->finish * kPerMetre);
      if (const auto& elastic = edge->elastic)
        item[kElasticKey] = {{"ratio", elastic->ratio},
                             {"stiffness", elastic->stiffness},
                             {"width", tidy(elastic->width * kPerMetre)},
                             {"linear_density", elastic->linear_density}};
      edges.push_back(item);
    }
    // Placement in the frame of the file, in centimetres and degrees.
    const Mat3 to_file = frame_from_y_up().transpose();
    const Vec3 translation = to_file * panel.translation * kPerMetre;
    panels += fmt::format(
        "{}\n      {}: {{\n        \"label\": {},\n{}        \"translation\": {},\n"
        "        \"rotation\": {},\n        \"vertices\": {},\n        \"edges\": {}\n      }}",
        p ? "," : "", Json(panel.name).dump(), Json(panel.label).dump(),
        cloth_line(panel.cloth) + holes_line(panel.holes), numbers(translation).dump(),
        numbers(euler_deg_from_rotation(to_file * panel.rotation)).dump(),
        list_lines(vertices, "        "), list_lines(edges, "        "));
  }

  // A seam becomes as many stitches as its edges have parts.
  std::vector<Json> stitches;
  for (const pattern::Stitch& s : pattern.stitches) {
    const auto [first_a, count] = range[s.first.panel][s.first.edge];
    const auto [first_b, count_b] = range[s.second.panel][s.second.edge];
    for (int i = 0; i < count; ++i) {
      Json first = {{"panel", pattern.panels[s.first.panel].name}, {"edge", first_a + i}};
      if (!s.name.empty()) first["name"] = s.name;
      Json item = Json::array({first,
                               {{"panel", pattern.panels[s.second.panel].name},
                                {"edge", first_b + (s.right_wrong ? i : count_b - 1 - i)}}});
      if (s.right_wrong) item.push_back("right_wrong");
      stitches.push_back(item);
    }
  }
  // The mark of our own draft, and the order of the panels.
  const std::string draft = kinds::draft_mark(pattern);
  const std::string mark =
      draft.empty() ? "" : fmt::format(",\n    \"{}\": \"{}\"", kDraftKey, draft);
  Json order = Json::array();
  for (const int p : pattern.panel_order) order.push_back(pattern.panels[p].name);
  return fmt::format(
      "{{\n  \"pattern\": {{\n    \"panels\": {{{}\n    }},\n    \"stitches\": {},\n"
      "    \"panel_order\": {}\n  }},\n  \"properties\": {{\n"
      "    \"curvature_coords\": \"relative\",\n    \"normalize_panel_translation\": false,\n"
      "    \"normalized_edge_loops\": true,\n    \"units_in_meter\": {:g}{}\n  }}\n}}\n",
      panels, list_lines(stitches, "    "), order.dump(), kPerMetre, mark);
}

void write_garmentcode(const std::filesystem::path& path, const pattern::Pattern& pattern) {
  write_text_file(path.string(), json_without_controls(garmentcode_text(pattern)));
}

}  // namespace loosefit::io
