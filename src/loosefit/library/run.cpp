#include "loosefit/library/run.h"

#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/pipeline/summary.h"

namespace loosefit::library {
namespace {

Surface surface_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  Surface surface;
  surface.vertices.reserve(vertices.size());
  for (const Vec3& v : vertices) surface.vertices.push_back({v.x(), v.y(), v.z()});
  surface.triangles = triangles;
  return surface;
}

Garment garment_of(pipeline::CaseGarment&& from) {
  const garment::Garment& mesh = from.mesh();
  Garment garment;
  garment.surface = surface_of(from.drape.positions, mesh.triangles);
  for (const Vec2& uv : mesh.vertex_uv) garment.pattern_uv.push_back({uv.x(), uv.y()});
  garment.panel = mesh.vertex_panel;
  garment.panel_names = mesh.panel_names;
  garment.mass = mesh.mass;
  for (pipeline::CaseMap& map : from.maps.maps)
    garment.maps.push_back({map.map.array, map.map.title, map.map.unit, std::move(map.map.values)});
  return garment;
}

Verdict verdict_of(const pipeline::CaseResult& result) {
  const drape::Certificate& certificate = result.certificate();
  Verdict verdict;
  verdict.settled = certificate.settled();
  verdict.worn = certificate.worn();
  verdict.holds = certificate.holds();
  verdict.stable = certificate.stable;
  verdict.residual = certificate.residual;
  verdict.intersections_body = certificate.intersections_body;
  verdict.intersections_self = certificate.intersections_self;
  verdict.stop_reason = certificate.stop_reason;
  verdict.worn_reasons = certificate.worn_reasons;
  verdict.can_be_put_on = result.putting_on.possible;
  verdict.can_be_put_on_reasons = result.putting_on.reasons;
  return verdict;
}

Outcome run_scenario(const scenario::Scenario& scenario, const RunSettings& settings,
                     Progress& progress) {
  pipeline::CaseResult result = pipeline::run_case(
      scenario, progress,
      {.allow_unsettled = settings.allow_unsettled, .only_drape = settings.only_drape});
  Outcome outcome;
  outcome.summary_json = pipeline::summary_json(result);
  outcome.verdict = verdict_of(result);
  const geometry::TriangleMesh& skin = result.body.body->surface;
  outcome.body = surface_of(skin.vertices, skin.triangles);
  for (pipeline::CaseGarment& garment : result.garments)
    outcome.garments.push_back(garment_of(std::move(garment)));
  outcome.warnings = std::move(result.warnings);
  return outcome;
}

}  // namespace

Outcome run(const std::filesystem::path& scenario, const RunSettings& settings,
            Progress& progress) {
  return run_scenario(io::read_scenario(scenario.string()), settings, progress);
}

Outcome run(const std::filesystem::path& scenario, const RunSettings& settings) {
  Progress silent;
  return run(scenario, settings, silent);
}

Outcome run_text(const std::string& text, const std::string& name, const RunSettings& settings,
                 Progress& progress) {
  return run_scenario(io::parse_scenario(text, name), settings, progress);
}

Outcome run_text(const std::string& text, const std::string& name, const RunSettings& settings) {
  Progress silent;
  return run_text(text, name, settings, silent);
}

}  // namespace loosefit::library
