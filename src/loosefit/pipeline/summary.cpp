#include "loosefit/pipeline/summary.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/sha256.h"
#include "loosefit/base/version.h"
#include "loosefit/body/floor_under.h"
#include "loosefit/body/stumps.h"
#include "loosefit/io/address_columns.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/pipeline/answers_json.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/pipeline/draped_from.h"
#include "loosefit/pipeline/lines_json.h"
#include "loosefit/pipeline/site_values.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

using Json = nlohmann::ordered_json;

Json statistics_json(const maps::MapStatistics& s) {
  return {{"min", s.min}, {"p5", s.p5},   {"median", s.median},
          {"p95", s.p95}, {"max", s.max}, {"area_mean", s.area_mean}};
}

/// `worn`: the garment in that state.
Json maps_json(const std::vector<CaseMap>& maps, const garment::Garment& garment,
               const maps::WornGarment& worn) {
  Json json = Json::object();
  for (const CaseMap& map : maps) {
    Json& entry = json[map.map.array] = statistics_json(map.overall);
    entry["undefined_vertices"] = map.overall.undefined;
    for (const auto& [region, statistics] : map.regional)
      entry["regions"][body::name(region)] = statistics_json(statistics);
    if (worn.areas.size() != map.map.values.size()) continue;  // not made of this drape
    for (int p = 0; p < static_cast<int>(garment.panel_names.size()); ++p) {
      std::vector<double> areas = worn.areas;
      for (std::size_t v = 0; v < areas.size(); ++v)
        if (garment.vertex_panel[v] != p) areas[v] = 0;
      const maps::MapStatistics own = maps::statistics(map.map.values, areas);
      if (own.area > 0) entry["panels"][garment.panel_names[p]] = statistics_json(own);
    }
  }
  return json;
}

Json wrinkles_json(const std::map<body::Region, maps::WrinkleDirection>& wrinkles) {
  Json json = Json::object();
  for (const auto& [region, w] : wrinkles)
    json[body::name(region)] = {{"angle_deg", degrees(w.angle)},
                                {"coherence", w.coherence},
                                {"slope_rms_deg", degrees(w.slope)}};
  return json;
}

Json agreement_json(const maps::PressureAgreement& a) {
  return {{"contact_area_m2", a.contact_area},
          {"mean_kPa", a.contact_mean / 1000},
          {"mean_membrane_kPa", a.membrane_mean / 1000},
          {"normal_force_N", a.contact_force},
          {"normal_force_membrane_N", a.membrane_force},
          {"rms_difference_kPa", a.rms_difference / 1000},
          {"correlation", a.correlation}};
}

Json pressure_json(const CasePressure& pressure) {
  Json json = agreement_json(pressure.overall);
  json["contact_share_of_pressed_area"] = pressure.contact_share.of_places;
  json["touching_share_of_pressed_area"] = pressure.contact_share.of_triangles;
  const std::vector<double> shares = maps::pressure_class_shares(pressure.field);
  for (std::size_t i = 0; i < shares.size(); ++i)
    json["area_share"][maps::kPressureClassNames[i]] = shares[i];
  for (const auto& [region, agreement] : pressure.regional)
    json["regions"][body::name(region)] = agreement_json(agreement);
  return json;
}

/// Whether a garment that is meant to hang hangs.
Json load_json(const maps::BodyLoad& load) {
  Json json = {{"normal_force_N", load.normal_force},
               {"weight_N", load.weight},
               {"force_over_weight", load.force_over_weight()},
               {"between_arm_and_trunk_N", load.between_arm_and_trunk}};
  for (const std::string& limb : maps::limb_names())
    json["share_of_limb"][limb] =
        load.normal_force > 0 ? load.of_limb.at(limb) / load.normal_force : 0;
  for (std::size_t k = 0; k < maps::kNearGaps.size(); ++k)
    json["contact_share"].push_back(
        {{"gap_mm", 1e3 * maps::kNearGaps[k]}, {"share", load.near_share[k]}});
  return json;
}

/// Limits are null where the card states none.
Json strain_range_json(const maps::StrainRange& range, const scenario::MaterialCard& card) {
  const auto direction = [](const maps::DirectionRange& d) {
    return Json{{"limit", d.is_stated() ? Json(d.limit) : Json(nullptr)},
                {"largest", d.largest},
                {"share_beyond", d.share_beyond}};
  };
  return {{"warp", direction(range.warp)},
          {"weft", direction(range.weft)},
          {"shear_rad", direction(range.shear)},
          {"share_beyond", range.share_beyond},
          {"crushed_triangles", range.crushed.size()},
          {"torn_triangles", range.torn.size()},
          {"least_of_any_triangle", range.least},
          {"greatest_of_any_triangle", range.most},
          {"source", card.valid_strain_source}};
}

/// Ease by station, as cut and as asked; null where nobody asked.
Json ease_json(const CaseGarment& garment, const scenario::GarmentSpec& spec) {
  Json json = {{"stations", Json::array()}, {"least", nullptr}};
  const std::vector<StationEase> stations = station_eases(garment, spec);
  for (const StationEase& s : stations)
    json["stations"].push_back(
        {{"name", s.name}, {"cut", s.cut}, {"asked", s.asked ? Json(*s.asked) : Json(nullptr)},
         {"worn", s.worn ? Json(*s.worn) : Json(nullptr)}});
  if (const auto least = least_cut_ease(stations))
    json["least"] = {{"name", least->name}, {"cut", least->cut}};
  return json;
}

Json body_json(const CaseBody& body) {
  Json json = {{"measured", Json::object()}, {"asked", Json::object()}};
  for (const auto& [key, value] : body.body->measured) json["measured"][key] = value;
  for (const body::MeasureRow& row : body.asked) json["asked"][row.name] = row.asked;
  const std::optional<double> floor = body::floor_under(body.body.body());
  json["floor_m"] = floor ? Json(*floor) : Json(nullptr);
  json["missing"] =
      body.parameters.stumps ? body.parameters.stumps->names() : std::vector<std::string>{};
  return json;
}

Json fit_json(const CaseGarment& garment) {
  Json json = {{"measured", Json::object()}, {"girths", Json::object()}};
  for (const auto& [level, mobility] : garment.pattern.fit) json["measured"][level] = mobility;
  for (const auto& [level, girth] : garment.pattern.girths) json["girths"][level] = girth;
  for (const StationFit& s : garment.pattern.fit_along) {
    Json station = {{"limb", s.limb},         {"place", s.place}, {"along_m", s.along},
                    {"garment_m", s.garment}, {"body_m", s.body}, {"cut", s.cut()}};
    if (s.asked) station["asked"] = *s.asked;
    json["stations"].push_back(station);
    Json& least = json["least"][s.limb];
    if (least.is_null() || s.cut() < least["cut"].get<double>()) least = station;
  }
  if (!garment.maps.maps.empty()) {
    const maps::GarmentGirth& chest = garment.maps.chest;
    json["chest_cut"] = {{"level", chest.level},
                         {"draped", chest.draped},
                         {"flat", chest.flat},
                         {"hoop_strain", chest.hoop_strain()}};
  }
  return json;
}

Json material_json(const scenario::MaterialCard& card) {
  Json json = {{"name", card.material.name},
               {"source", card.material.source},
               {"bending_length_m", io::bending_length(card.material)}};
  for (const io::ConstantInUse& c : io::constants_in_use(card))
    json["constants"][c.key] = {{"value", c.value}, {"unit", c.unit}, {"from", c.from}};
  return json;
}

Json garment_json(const CaseGarment& garment, const scenario::MaterialCard& material) {
  const garment::Garment& mesh = garment.mesh();
  double force = 0;
  for (double f : garment.drape.body_normal_force) force += f;
  return {{"pattern", garment.pattern.pattern.name},
          {"material", material_json(material)},
          {"vertices", mesh.vertex_count},
          {"triangles", mesh.triangles.size()},
          {"area_m2", mesh.area},
          {"mass_kg", mesh.mass},
          {"normal_force_on_body_N", force}};
}

/// What is worn, the innermost first; the maps of the last, the studied one, are those of the case.
Json garments_json(const CaseResult& result) {
  Json json = Json::array();
  for (std::size_t g = 0; g < result.garments.size(); ++g) {
    const CaseGarment& garment = result.garments[g];
    Json entry = garment_json(garment, result.scenario.garments[g].material);
    if (g + 1 < result.garments.size()) {
      entry["fit"] = fit_json(garment);
      entry["maps"] = maps_json(garment.maps.maps, garment.mesh(), garment.maps.worn);
      if (!garment.maps.pressure.field.empty())
        entry["pressure"] = pressure_json(garment.maps.pressure);
    }
    json.push_back(std::move(entry));
  }
  return json;
}

/// `by_donning`: also every sample of the sensor, not their medians alone, and what values may be
/// off by on a mesh of this edge length [m].
Json uncertainty_json(const placement::Site& site, double edge_length) {
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  Json json = Json::object();
  for (const auto& [name, known] : site_uncertainty(site, edge_length))
    json[name] = {{"mesh", number(known.mesh)}, {"donnings", number(known.donnings)}};
  return json;
}

Json site_json(const placement::Site& site, bool by_donning, double edge_length) {
  Json json = {{"panel", site.panel},
               {"u_m", site.at.x()},
               {"v_m", site.at.y()},
               {"position_m", {site.position.x(), site.position.y(), site.position.z()}},
               {"region", body::name(site.region)},
               {"angle_deg", degrees(site.angle)},
               {"body_address", nullptr},
               {"covered", site.not_covering.empty()}};
  if (!site.not_covering.empty()) json["why_not_covered"] = site.not_covering;
  if (site.anatomy)
    json["body_address"] = {
        {"segment", placement::name(site.anatomy->segment)},
        {"side", io::side_name(*site.anatomy)},
        {"percent",
         {site.anatomy->percent.x(), site.anatomy->percent.y(), site.anatomy->percent.z()}}};
  json["footprint"] = Json::parse(footprint_json(site.shape));
  for (const auto& [name, value] : site_values(site)) json[name] = value;
  if (by_donning) {
    json["uncertainty"] = uncertainty_json(site, edge_length);
    Json& all = json["by_donning"] = Json::object();
    for (std::size_t k = 0; k < site.samples.size(); ++k)
      for (const auto& [name, value] : site.samples[k]) {
        Json& list = all[name];
        if (list.is_null()) list = Json(std::vector<Json>(site.samples.size(), nullptr));
        list[k] = std::isfinite(value) ? Json(value) : Json(nullptr);
      }
  }
  return json;
}

Json seconds_json(const std::vector<StageClock::Entry>& entries) {
  Json json = Json::object();
  double total = 0;
  for (const StageClock::Entry& entry : entries) {
    json[entry.stage] = entry.seconds;
    total += entry.seconds;
  }
  json["total"] = total;
  return json;
}

Json work_json(const solver::SolverWork& work) {
  return {{"iterations", work.iterations},
          {"factorisations", work.factorisations},
          {"regional_iterations", work.regional},
          {"seconds",
           {{"assemble", work.assemble},
            {"factorise", work.factorise},
            {"solve", work.solve},
            {"collide", work.collide},
            {"evaluate", work.evaluate},
            {"refresh", work.refresh},
            {"region", work.region}}}};
}

Json parts_json(const std::vector<drape::PartWork>& parts) {
  Json json = Json::array();
  for (const drape::PartWork& part : parts) {
    json.push_back(work_json(part.work));
    json.back()["part"] = part.part;
    json.back()["level"] = part.level + 1;
    json.back()["vertices"] = part.vertices;
    json.back()["start"] = part.start + 1;
  }
  return json;
}

/// Null where it was not tested.
Json stable_json(const drape::Certificate& certificate) {
  return certificate.stable ? Json(*certificate.stable) : Json(nullptr);
}

Json settle_json(const drape::SettleReport& report) {
  const solver::SolverWork total = report.total();
  Json recoveries = Json::array();
  for (const drape::RecoveryCount& r : report.recoveries)
    recoveries.push_back({{"name", r.name}, {"times", r.times}});
  return {{"iterations", total.iterations},
          {"factorisations", total.factorisations},
          {"parts", parts_json(report.parts)},
          {"ccd_queries", report.ccd_queries},
          {"recoveries", std::move(recoveries)},
          {"contacts_body", report.contacts_body},
          {"contacts_self", report.contacts_self},
          {"held_off_triangles", report.held_off_triangles},
          {"largest_contact_offset_mm", 1e3 * report.largest_contact_offset},
          {"coarsened_field_mm", 1e3 * report.coarsened_field},
          {"floor_force_N", report.floor_force},
          {"bearing_area_m2", report.bearing_area},
          {"bearing_distance_mm",
           report.bearing_distance ? Json(1e3 * *report.bearing_distance) : Json(nullptr)}};
}

Json unsettled_json(const drape::Unsettled& u) {
  Json json = {{"why", u.why},
               {"hint", u.hint},
               {"times_allowed", u.times_allowed},
               {"vertices_of_90_percent", u.vertices_of_most},
               {"lagging_friction_share", u.lagging_share},
               {"worst", Json::array()},
               {"cuts", Json::array()}};
  const auto place = [](const auto& p, Json& entry) {
    entry["panel"] = p.panel;
    entry["u_m"] = p.at.x(), entry["v_m"] = p.at.y();
    entry["position_m"] = {p.position.x(), p.position.y(), p.position.z()};
  };
  for (const drape::UnbalancedVertex& v : u.worst) {
    Json entry = {{"vertex", v.vertex}};
    place(v, entry);
    entry["near"] = v.near;
    entry["net_N"] = v.net;
    for (std::size_t k = 0; k < v.force.size(); ++k)
      entry["force_N"][drape::kForceNames[k]] = v.force[k];
    json["worst"].push_back(std::move(entry));
  }
  for (const drape::CutTriangle& c : u.cuts) {
    Json entry = {{"triangle", c.triangle}};
    place(c, entry);
    entry["cuts"] = c.body ? "body" : "cloth";
    entry["with"] = c.with;
    json["cuts"].push_back(std::move(entry));
  }
  return json;
}

Json movements_json(const std::vector<CaseMovement>& movements) {
  Json json = Json::array();
  for (const CaseMovement& m : movements) json.push_back({{"name", m.name}, {"size", m.size}});
  return json;
}

Json donnings_json(const std::vector<CaseDonning>& donnings) {
  Json json = Json::array();
  for (const CaseDonning& d : donnings)
    json.push_back({{"shift_m", {d.shift.x(), d.shift.y(), d.shift.z()}},
                    {"twist_deg", degrees(d.twist)},
                    {"friction", d.friction},
                    {"movements", movements_json(d.movements)}});
  return json;
}

/// Postures, donnings, and what became of each of their drapes.
void add_wear(const CaseWear& wear, const garment::Garment& garment, Json& json) {
  json["postures"] = wear.postures;
  json["donnings"] = donnings_json(wear.donnings);
  json["states"] = Json::array();
  for (const CaseState& s : wear.states) {
    const drape::Certificate c = s.certificate();
    const drape::SettleReport report = s.draped() ? s.drape().report : drape::SettleReport{};
    Json entry = {
        {"posture", s.name},
        {"donning", s.id.donning + 1},
        {"counts", s.counts()},
        {"settled", c.settled()},
        {"worn", s.draped() ? Json(c.worn()) : Json(nullptr)},
        {"worn_reasons", c.worn_reasons},
        {"residual", c.residual},
        {"residual_max", c.residual_max},
        {"stable", stable_json(c)},
        {"intersections", {{"body", c.intersections_body}, {"self", c.intersections_self}}},
        {"stop_reason", s.left_out.empty() ? c.stop_reason : s.left_out},
        {"seconds", s.seconds},
        {"iterations", report.total().iterations},
        {"held_off_triangles", report.held_off_triangles},
        {"largest_contact_offset_mm", 1e3 * report.largest_contact_offset},
        {"coarsened_field_mm", 1e3 * report.coarsened_field}};
    if (s.draped() && s.drape().unsettled)
      entry["unsettled"] = unsettled_json(*s.drape().unsettled);
    if (!s.maps.maps.empty()) entry["maps"] = maps_json(s.maps.maps, garment, s.maps.worn);
    if (!s.maps.wrinkles.empty()) entry["wrinkles"] = wrinkles_json(s.maps.wrinkles);
    for (const placement::Site& site : s.sites)
      entry["sites"][site.name] = site_json(site, false, 0);
    if (!report.parts.empty()) entry["parts"] = parts_json(report.parts);
    json["states"].push_back(std::move(entry));
  }
  json["donning_warnings"] = wear.warnings;
}

Json certificate_json(const CaseResult& result) {
  const drape::Certificate& certificate = result.certificate();
  Json json;
  json["settled"] = certificate.settled();
  json["worn"] = certificate.worn();
  json["worn_reasons"] = certificate.worn_reasons;
  json["can_be_put_on"] =
      result.putting_on.possible ? Json(*result.putting_on.possible) : Json(nullptr);
  json["can_be_put_on_reasons"] = result.putting_on.reasons;
  json["sealed"] = result.sealed();
  json["residual"] = certificate.residual;
  json["residual_max"] = certificate.residual_max;
  json["stable"] = stable_json(certificate);
  json["intersections"] = {{"body", certificate.intersections_body},
                           {"self", certificate.intersections_self},
                           {"folded_edges", certificate.folded_edges}};
  if (!result.worn_under().empty())
    json["intersections"]["layers"] = certificate.intersections_layers;
  json["stop_reason"] = certificate.stop_reason;
  return json;
}

}  // namespace

std::string summary_json(const CaseResult& result) {
  const CaseGarment& studied = result.studied();
  const garment::Garment& mesh = studied.mesh();
  const CaseMaps& maps = studied.maps;

  // Whether the numbers count, and what they took.
  Json json = certificate_json(result);
  json["vertices"] = mesh.vertex_count;
  json["triangles"] = mesh.triangles.size();
  json["seconds"] = seconds_json(result.seconds);
  json["peak_memory_mb"] = result.peak_memory_mb;
  json["settle"] = settle_json(studied.drape.report);
  json["settle"]["movements"] = movements_json(result.body.movements);
  json["settle"]["warnings"] = result.body.dressing_warnings;
  if (studied.drape.unsettled)
    json["settle"]["unsettled"] = unsettled_json(*studied.drape.unsettled);

  json["answers"] = Json::parse(answers_json(result.answers));

  // Who wears what.
  json["body"] = body_json(result.body);
  json["fit"] = fit_json(studied);
  json["garment"] = {{"area_m2", mesh.area}, {"mass_kg", mesh.mass}};
  json["ease"] = ease_json(studied, result.scenario.studied().spec);
  json["material"] = material_json(result.scenario.studied().material);
  if (!result.worn_under().empty()) json["garments"] = garments_json(result);

  // Maps, states, sites and spreads.
  json["maps"] = maps_json(maps.maps, mesh, maps.worn);
  if (!maps.wrinkles.empty()) json["wrinkles"] = wrinkles_json(maps.wrinkles);
  if (!maps.pressure.field.empty()) json["pressure"] = pressure_json(maps.pressure);
  if (maps.load) json["load"] = load_json(*maps.load);
  if (!maps.maps.empty())
    json["strain_range"] = strain_range_json(maps.strain_range, result.scenario.studied().material);
  if (!result.wear.postures.empty())
    add_wear(result.wear, mesh, json);
  else if (result.scenario.donning.first_drawn)
    json["donnings"] = donnings_json(planned_donnings(result.scenario.donning));
  json["sites"] = Json::object();
  for (const placement::Site& site : result.sites)
    json["sites"][site.name] = site_json(site, true, result.scenario.simulation.edge_length);
  for (const CaseLine& line : result.lines)
    json["lines"][line.name] = Json::parse(lines_json(line, mesh));
  for (const placement::UncoveredSite& line : result.lines_left_out)
    json["lines_left_out"][line.name] = line.why;
  for (const placement::UncoveredSite& site : result.uncovered_sites)
    json["uncovered_sites"][site.name] = {{"preset", site.preset}, {"why", site.why}};
  for (const auto& [key, spread] : result.repeats.spread)
    json["repeats"][key] = {
        {"mean", spread.mean}, {"deviation", spread.deviation}, {"count", spread.count}};
  if (!result.repeats.warnings.empty()) json["repeat_warnings"] = result.repeats.warnings;

  // What made them.
  json["warnings"] = result.warnings;
  for (const auto& [library, number] : versions()) json["versions"][library] = number;
  json["draped_from"] = draped_from(result.scenario);
  json["scenario_sha256"] = sha256_hex(io::scenario_toml(result.scenario));
  return json_without_controls(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace loosefit::pipeline
