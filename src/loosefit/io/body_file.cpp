#include "loosefit/io/body_file.h"

#include <nlohmann/json.hpp>

#include "loosefit/body/stumps.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::ordered_json;

Json points(const std::map<std::string, Vec3>& named) {
  Json json = Json::object();
  for (const auto& [name, p] : named) json[name] = {p.x(), p.y(), p.z()};
  return json;
}

Json parameters_json(const body::BodyParameters& p) {
  Json json = {{"sex", p.sex},       {"age", p.age},          {"muscle", p.muscle},
               {"weight", p.weight}, {"height", p.height},    {"proportions", p.proportions},
               {"cup", p.cup},       {"firmness", p.firmness}};
  json["ancestry"] = {
      {"african", p.ancestry[0]}, {"asian", p.ancestry[1]}, {"caucasian", p.ancestry[2]}};
  json["details"] = p.details;
  return json;
}

}  // namespace

void write_body_json(const std::string& path, const body::Body& body, const body::BodyFit& fit) {
  Json json;
  json["vertices"] = body.surface.vertices.size();
  json["triangles"] = body.surface.triangles.size();
  json["measured"] = body.measured;
  json["asked"] = Json::array();
  for (const auto& row : fit.table) {
    json["asked"].push_back({{"name", row.name}, {"asked", row.asked}, {"measured", row.measured}});
  }
  json["warnings"] = fit.warnings;
  json["missing"] =
      fit.parameters.stumps ? fit.parameters.stumps->names() : std::vector<std::string>{};
  const bool scan = body.pose_from_rest.empty();
  if (!scan) json["parameters"] = parameters_json(fit.parameters);
  json["landmarks"] = points(body.landmarks);
  json["landmark_vertex"] = body.landmark_vertex;
  json["joints"] = points(body.joints);
  write_text_file(path, json.dump(1) + "\n");
}

}  // namespace loosefit::io
