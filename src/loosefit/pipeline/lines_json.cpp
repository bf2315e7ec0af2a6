#include "loosefit/pipeline/lines_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace loosefit::pipeline {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json sensitivity_json(const lines::Sensitivity& s) {
  Json json = {{"joint", s.joint},
               {"gain_percent_per_deg", 100 * s.gain},
               {"monotone_deg", {s.monotone_from, s.monotone_to}},
               {"rises", s.rises},
               {"angle_error_deg", finite(s.angle_error)},
               {"curve", Json::array()},
               {"cross", Json::array()}};
  for (const lines::CurvePoint& p : s.curve)
    json["curve"].push_back({{"deg", p.degrees},
                             {"signal", p.mean},
                             {"deviation", p.deviation},
                             {"donnings", p.signals.size()}});
  for (const lines::CrossEffect& c : s.cross)
    json["cross"].push_back(
        {{"posture", c.posture}, {"change", c.change}, {"as_degrees", finite(c.degrees)}});
  return json;
}

Json pattern_json(const lines::LineCourse& course, const garment::Garment& mesh) {
  Json json = Json::array();
  for (const lines::PanelStretch& stretch : lines::stretches(mesh, course)) {
    Json points = Json::array();
    for (const Vec2& p : stretch.points) points.push_back({p.x(), p.y()});
    json.push_back({{"panel", mesh.panel_names[stretch.panel]}, {"points_m", points}});
  }
  return json;
}

Json route_json(const lines::Route& route, const garment::Garment& mesh) {
  return {{"length_cut_m", route.course.length},
          {"strain", route.strain},
          {"mean_strain", route.mean_strain},
          {"bend_radius_mm", finite(1e3 * route.bend_radius)},
          {"slip_mm", finite(1e3 * route.slip)},
          {"seams", route.seams},
          {"pattern", pattern_json(route.course, mesh)}};
}

}  // namespace

std::string lines_json(const CaseLine& line, const garment::Garment& mesh) {
  Json json = {{"length_cut_m", line.course.length}, {"metrics", Json::array()}};
  if (!line.states.empty()) json["length_worn_m"] = line.states.front().length;
  for (const auto& metrics : line.metrics) json["metrics"].push_back(metrics);
  json["pattern"] = pattern_json(line.course, mesh);
  for (const lines::Route& route : line.routes) json["routes"].push_back(route_json(route, mesh));
  if (line.shortest) json["shortest"] = route_json(*line.shortest, mesh);
  if (!line.states.empty()) json["parts"] = line.states.front().parts;
  json["scores"] = Json::object();
  for (const CaseLine::Verdict& v : line.verdicts)
    json["scores"][v.scorecard] = {{"score", v.score.q ? Json(*v.score.q) : Json(nullptr)},
                                   {"passes", v.passes()},
                                   {"reason", v.score.reason}};
  json["sensitivities"] = Json::array();
  for (const lines::Sensitivity& s : line.sensitivities)
    json["sensitivities"].push_back(sensitivity_json(s));
  return json.dump();
}

}  // namespace loosefit::pipeline
