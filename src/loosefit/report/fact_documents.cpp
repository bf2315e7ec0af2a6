#include "loosefit/report/fact_documents.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "loosefit/base/version.h"
#include "loosefit/body/stumps.h"
#include "loosefit/io/material_file.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::report {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void add_written(Json& json, const WrittenFiles& written) {
  json["folder"] = written.folder.empty() ? Json(nullptr) : Json(written.folder);
  json["files"] = written.files;
}

Json levels_json(const std::vector<kinds::FitLevel>& levels) {
  Json list = Json::array();
  for (const kinds::FitLevel& level : levels) {
    Json entry = {{"level", level.name},
                  {"body_m", nullptr},
                  {"garment_m", level.garment},
                  {"mobility", nullptr}};
    if (level.body) {
      entry["body_m"] = *level.body;
      entry["mobility"] = level.garment / *level.body - 1;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Json piece_json(const pattern::Panel& panel) {
  const std::vector<Vec2> outline = pattern::outline_polygon(panel);
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return {{"name", panel.name},
          {"width_m", (high - low).x()},
          {"height_m", (high - low).y()},
          {"area_m2", pattern::signed_area(outline)},
          {"edges", panel.edges.size()}};
}

Json seam_json(const pattern::Pattern& pattern, const pattern::Stitch& stitch) {
  const auto side = [&](const pattern::Stitch::Side& end) {
    const pattern::Panel& panel = pattern.panels[end.panel];
    return Json{{"piece", panel.name},
                {"edge", panel.edges[end.edge].name},
                {"length_m", pattern::EdgePath(panel, end.edge).length()}};
  };
  return {{"name", stitch.name},
          {"first", side(stitch.first)},
          {"second", side(stitch.second)},
          {"right_to_wrong", stitch.right_wrong}};
}

Json material_json(const scenario::MaterialCard& card) {
  const fabric::Material& m = card.material;
  Json constants = Json::array();
  for (const io::ConstantInUse& c : io::constants_in_use(card))
    constants.push_back({{"key", c.key}, {"value", c.value}, {"unit", c.unit}, {"from", c.from}});
  Json kes = Json::array();
  for (const scenario::KesFigure& f : card.kes)
    kes.push_back(
        {{"key", f.key}, {"value", f.value}, {"unit", f.unit.unit}, {"meaning", f.unit.meaning}});
  Json curves = Json::object();
  const auto curve = [&](const char* name, const std::vector<fabric::CurvePoint>& points,
                         const char* strain) {
    if (points.empty()) return;
    Json strains = Json::array(), forces = Json::array();
    for (const fabric::CurvePoint& p : points) {
      strains.push_back(p.strain);
      forces.push_back(p.force);
    }
    curves[name] = {{strain, strains}, {"force_n_per_m", forces}};
  };
  curve("warp", m.curve_warp, "elongation");
  curve("weft", m.curve_weft, "elongation");
  curve("shear", m.curve_shear, "green_shear");
  return {{"name", card.material.name},
          {"title", card.title},
          {"source", m.source},
          {"status", card.status},
          {"constants", constants},
          {"bending_length_warp_m", io::bending_length(m, m.bending_warp)},
          {"bending_length_weft_m", io::bending_length(m, m.bending_weft)},
          {"residual_curvature_warp_per_m", m.bending_hysteresis_warp / m.bending_warp},
          {"residual_curvature_weft_per_m", m.bending_hysteresis_weft / m.bending_weft},
          {"kes", kes},
          {"curves", curves},
          {"notes", card.notes}};
}

}  // namespace

std::string body_document(const body::Body& body, const body::BodyFit& fit,
                          const WrittenFiles& written) {
  Json asked = Json::array();
  for (const body::MeasureRow& row : fit.table)
    asked.push_back({{"measure", row.name}, {"asked_m", row.asked}, {"measured_m", row.measured}});
  Json measured = Json::object();
  for (const auto& [name, value] : body.measured)
    measured[name + (name == "volume"           ? "_m3"
                     : name == "mass"           ? "_kg"
                     : name == "shoulder_slope" ? "_rad"
                                                : "_m")] = value;
  Json json = {{"asked", asked}, {"measured", measured}, {"warnings", fit.warnings}};
  json["missing"] =
      fit.parameters.stumps ? fit.parameters.stumps->names() : std::vector<std::string>{};
  add_written(json, written);
  return text_of(json);
}

std::string pattern_document(const pipeline::GarmentPattern& made, const WrittenFiles& written) {
  Json pieces = Json::array(), seams = Json::array();
  for (const pattern::Panel& panel : made.pattern.panels) pieces.push_back(piece_json(panel));
  for (const pattern::Stitch& stitch : made.pattern.stitches)
    seams.push_back(seam_json(made.pattern, stitch));
  Json json = {
      {"name", made.pattern.name}, {"about", made.about},      {"levels", levels_json(made.levels)},
      {"pieces", pieces},          {"seams", seams},           {"details", made.details},
      {"unused", made.unused},     {"warnings", made.warnings}};
  add_written(json, written);
  return text_of(json);
}

std::string sizes_document(const kinds::GarmentKind& kind) {
  Json sizes = Json::array();
  for (const kinds::KindSize& size : kind.sizes) {
    const kinds::DraftedGarment garment = kind.draft({{}, size.name, {}, {}});
    sizes.push_back(
        {{"name", size.name},
         {"levels", levels_json(kind.levels(garment.pattern, size.measures, garment.fit))},
         {"source", size.source}});
  }
  return text_of({{"pattern", kind.name}, {"sizes", sizes}});
}

std::string materials_document() {
  Json list = Json::array();
  for (const std::string& name : io::material_names()) {
    Json material = material_json(io::load_material(name));
    for (const char* detail : {"kes", "curves", "notes", "status"}) material.erase(detail);
    list.push_back(std::move(material));
  }
  return text_of({{"materials", list}});
}

std::string material_document(const scenario::MaterialCard& card) {
  return text_of(material_json(card));
}

std::string versions_document() { return text_of({{"versions", versions()}}); }

std::string doctor_document(const std::vector<Finding>& findings, bool can_run) {
  Json checks = Json::array();
  for (const Finding& f : findings)
    checks.push_back({{"what", f.what},
                      {"ok", f.ok},
                      {"found", f.found},
                      {"hint", f.hint.empty() ? Json(nullptr) : Json(f.hint)}});
  return text_of({{"can_run", can_run},
                  {"cores", std::thread::hardware_concurrency()},
                  {"checks", checks},
                  {"versions", versions()}});
}

std::string checked_document(const std::vector<CheckedScenario>& checked) {
  Json list = Json::array();
  for (const CheckedScenario& one : checked) {
    Json entry = {{"file", one.file}, {"accepted", one.error.empty()}, {"error", nullptr}};
    if (!one.error.empty()) entry["error"] = Json::parse(one.error)["error"];
    list.push_back(std::move(entry));
  }
  return text_of({{"scenarios", list}});
}

}  // namespace loosefit::report
