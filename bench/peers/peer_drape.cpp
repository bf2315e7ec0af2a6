// Drapes a garment that stands round a plain closed surface, and writes what another cloth program
// needs for the same case; see README.md.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/resources.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/mesh_file.h"
#include "loosefit/io/mesh_obj.h"

namespace loosefit {
namespace {

/// The sheet that the programs of the comparison were given: E t = 261 N/m, ν = 0.243, isotropic.
fabric::Material common_material() {
  fabric::Material m;
  m.areal_density = 0.15;
  m.thickness = 5e-4;
  m.stiffness_warp = m.stiffness_weft = 261;
  m.poisson = m.bending_poisson = 0.243;
  m.stiffness_shear = 261 / (2 * (1 + 0.243));
  m.bending_warp = m.bending_weft = 2.3e-6;
  m.friction_body = m.friction_self = 0.3;
  return m;
}

/// The flat panels where the pattern places them, not sewn, and the pairs of vertices to be sewn.
nlohmann::json unsewn(const garment::Garment& garment, const pattern::Pattern& pattern) {
  std::map<std::pair<int, int>, int> number;  // (panel, garment vertex) → vertex
  nlohmann::json vertices = nlohmann::json::array(), triangles = nlohmann::json::array(),
                 sewing = nlohmann::json::array();
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int p = pattern.find_panel(garment.panel_names[garment.triangle_panel[t]]);
    const pattern::Panel& panel = pattern.panels[p];
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const auto [entry, is_new] =
          number.emplace(std::pair(p, garment.triangles[t][k]), number.size());
      corners[k] = entry->second;
      if (!is_new) continue;
      const Vec2& uv = garment.triangle_uv[t][k];
      const Vec3 x = panel.rotation * Vec3(uv[0], uv[1], 0) + panel.translation;
      vertices.push_back({x[0], x[1], x[2]});
    }
    triangles.push_back(corners);
  }
  for (const auto& [key, vertex] : number)
    for (int other = key.first + 1; other < static_cast<int>(pattern.panels.size()); ++other)
      if (const auto found = number.find({other, key.second}); found != number.end())
        sewing.push_back({vertex, found->second});
  return {{"vertices", vertices}, {"triangles", triangles}, {"sewing", sewing}};
}

/// Of the edges of all triangles against the flat panels, as the peer reports them.
nlohmann::json edge_strain(const garment::Garment& garment, const std::vector<Vec3>& x) {
  std::vector<double> strain;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = garment.triangles[t][k], b = garment.triangles[t][(k + 1) % 3];
      const auto& uv = garment.triangle_uv[t];
      strain.push_back((x[b] - x[a]).norm() / (uv[(k + 1) % 3] - uv[k]).norm() - 1);
    }
  std::sort(strain.begin(), strain.end());
  const auto at = [&](double share) {
    return strain[std::min(strain.size() - 1, static_cast<std::size_t>(share * strain.size()))];
  };
  return {{"min", strain.front()},
          {"p1", at(0.01)},
          {"median", at(0.5)},
          {"p99", at(0.99)},
          {"max", strain.back()}};
}

void write(const std::string& file, const nlohmann::json& json) {
  std::ofstream out(file);
  out << json.dump() << '\n';
  if (!out.flush()) throw IoError(file + ": cannot be written");
}

int run(int argc, char** argv) {
  std::string pattern_file, body_file, panels_file, mesh_file, figures_file;
  double edge = 0.0113;
  int threads = 0;
  const drape::DrapeOptions options;
  CLI::App app{"Drapes a placed garment on a closed surface"};
  app.add_option("pattern", pattern_file, "GarmentCode JSON")->required();
  app.add_option("body", body_file, "OBJ, metres, z up")->required();
  app.add_option("--edge-length", edge, "metres")->check(CLI::Range(0.003, 0.05));
  app.add_option("--threads", threads)->check(CLI::Range(0, 256));
  app.add_option("--panels", panels_file, "write the unsewn panels here and stop");
  app.add_option("--mesh", mesh_file, "write the drape as OBJ");
  app.add_option("--json", figures_file, "write the figures here too");
  CLI11_PARSE(app, argc, argv);

  std::optional<tbb::global_control> limit;
  if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
  const auto start = std::chrono::steady_clock::now();
  const fabric::Material material = common_material();
  const pattern::Pattern pattern = io::read_garmentcode(pattern_file).pattern;
  const garment::GarmentHierarchy garment = garment::build_hierarchy(pattern, edge, material);
  if (!panels_file.empty()) {
    write(panels_file, unsewn(garment.finest(), pattern));
    return 0;
  }
  body::Body body;
  body.surface = io::read_mesh(body_file).mesh;
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  Progress progress;
  const drape::Drape drape = drape::drape_garment(
      garment, material, [&](double) { return body; }, options, progress);
  if (!mesh_file.empty()) io::write_obj(mesh_file, {drape.positions, garment.finest().triangles});
  const drape::Certificate& c = drape.certificate;
  const solver::SolverWork work = drape.report.total();
  const nlohmann::json figures{
      {"settled", c.settled()},
      {"stop_reason", c.stop_reason},
      {"residual", c.residual},
      {"residual_max", c.residual_max},
      {"intersections_body", c.intersections_body},
      {"intersections_self", c.intersections_self},
      {"vertices", garment.finest().vertex_count},
      {"triangles", garment.finest().triangles.size()},
      {"iterations", work.iterations},
      {"factorisations", work.factorisations},
      {"edge_strain", edge_strain(garment.finest(), drape.positions)},
      {"wall_seconds",
       std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
      {"peak_memory_mb", peak_memory_mb()}};
  if (!figures_file.empty()) write(figures_file, figures);
  fmt::print("{}\n", figures.dump(1));
  return c.settled() ? 0 : 1;
}

}  // namespace
}  // namespace loosefit

int main(int argc, char** argv) {
  try {
    return loosefit::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  }
}
