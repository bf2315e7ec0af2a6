// One sleeve on a bent arm, on meshes of different fineness, with the membrane of drapes or a
// trial: where does the mesh error of strains come from, and what lessens it?
//
//   loosefit_mesh_error --edge 10 --membrane arc --ease 0.10 --bend 44
//
// Prints one line of JSON.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/maps/definitions/trellis_shear.h"
#include "loosefit/maps/strain.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/validate/specimen.h"
#include "trial_membrane.h"

namespace {

using namespace loosefit;

/// An arm: a tapered tube along a centre line that is bent in a circular arc.
struct Arm {
  double upper = 0.08, fore = 0.08;  ///< straight parts [m]
  double top = 0.044, end = 0.034;   ///< radii at the ends [m]
  double elbow = 0.052;              ///< radius of the centre line's bend [m]
  double full = radians(60);         ///< whose arc length the bend always has
  double arc() const { return elbow * full; }
  double length() const { return upper + arc() + fore; }
  double radius(double s) const { return top + (end - top) * s / length(); }
  /// Of centre-line length s, angle round it, distance from it; bent by `bend` [rad].
  Vec3 place(double s, double round, double r, double bend) const {
    const double inside = std::clamp(s - upper, 0.0, arc()), turn = bend * inside / arc();
    Vec3 at(0, 0, -std::min(s, upper));
    if (bend > 1e-9) {
      const double rho = arc() / bend;
      at += rho * Vec3(1 - std::cos(turn), 0, -std::sin(turn));
    } else {
      at += Vec3(0, 0, -inside);
    }
    const Vec3 along(std::sin(turn), 0, -std::cos(turn)), side(std::cos(turn), 0, std::sin(turn));
    at += std::max(0.0, s - upper - arc()) * along;
    return at + r * (std::cos(round) * side + std::sin(round) * Vec3(0, 1, 0));
  }
  geometry::TriangleMesh body(double bend) const {
    geometry::TriangleMesh mesh;
    const int rows = 160, sectors = 120;
    const double s0 = -0.06, s1 = length() + 0.06;
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j < sectors; ++j) {
        const double s = s0 + (s1 - s0) * i / rows;
        Vec3 p = place(std::max(s, 0.0), 2 * kPi * j / sectors, radius(s), bend);
        if (s < 0) p[2] -= s;
        mesh.vertices.push_back(p);
      }
    const auto id = [&](int i, int j) { return i * sectors + j % sectors; };
    // Seen along the arm from the shoulder, `round` runs clockwise about it.
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < sectors; ++j) {
        mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      }
    for (int rim : {0, rows}) {
      Vec3 centre = Vec3::Zero();
      for (int j = 0; j < sectors; ++j) centre += mesh.vertices[id(rim, j)] / sectors;
      const int c = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(centre);
      for (int j = 0; j < sectors; ++j)
        if (rim)
          mesh.triangles.push_back({c, id(rim, j + 1), id(rim, j)});
        else
          mesh.triangles.push_back({c, id(rim, j), id(rim, j + 1)});
    }
    return mesh;
  }
  /// Centre-line length, angle and distance of a point near the arm.
  Vec3 address(const Vec3& p, double bend) const {
    const double rho = bend > 1e-9 ? arc() / bend : 0;
    const Vec3 centre(rho, 0, -upper);
    double s = -p[2], turn = 0;
    Vec3 on(0, 0, p[2]);
    if (s > upper && bend > 1e-9) {
      turn = std::clamp(std::atan2(-(p[2] + upper), rho - p[0]), 0.0, bend);
      s = upper + turn * rho;
      on = place(s, 0, 0, bend);
      if (turn >= bend) {
        const Vec3 along(std::sin(bend), 0, -std::cos(bend));
        const double beyond = std::max(0.0, (p - on).dot(along));
        s += beyond;
        on += beyond * along;
      }
    }
    const Vec3 side(std::cos(turn), 0, std::sin(turn)), off = p - on;
    return {s, std::atan2(off[1], off.dot(side)), off.norm()};
  }
};

double option(int argc, char** argv, const char* name, double otherwise) {
  for (int i = 1; i + 1 < argc; ++i)
    if (!std::strcmp(argv[i], name)) return std::atof(argv[i + 1]);
  return otherwise;
}
std::string word(int argc, char** argv, const char* name, const char* otherwise) {
  for (int i = 1; i + 1 < argc; ++i)
    if (!std::strcmp(argv[i], name)) return argv[i + 1];
  return otherwise;
}

bench::MembraneTrial trial_named(const std::string& name, double share) {
  bench::MembraneTrial trial;
  using Arc = bench::MembraneTrial::Arc;
  if (name.find("arc6") != std::string::npos)
    trial.arc = Arc::own_angles;
  else if (name.find("arc") != std::string::npos)
    trial.arc = Arc::patch;
  using Smooth = bench::MembraneTrial::Smooth;
  for (const auto& [part, smooth] :
       {std::pair{"node", Smooth::nodes}, {"edge", Smooth::edges}, {"pair", Smooth::pairs}})
    if (name.find(part) != std::string::npos) trial.smooth = smooth, trial.triangle_share = share;
  trial.shear_stays = name.find("shear") != std::string::npos;
  return trial;
}

/// Largest relative difference of the gradient from differences of the energy, and of the exact
/// Hessian from differences of the gradient.
void check(const bench::TrialMembrane& energy, particles::VectorField x) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> bump(-1, 1);
  for (Vec3& p : x) p += 5e-4 * Vec3(bump(random), bump(random), bump(random));
  const std::size_t n = x.size();
  particles::VectorField d(n), g(n, Vec3::Zero());
  for (Vec3& v : d) v = Vec3(bump(random), bump(random), bump(random));
  const double h = 1e-7;
  const auto moved = [&](double by) {
    particles::VectorField y = x;
    for (std::size_t i = 0; i < n; ++i) y[i] += by * d[i];
    return y;
  };
  energy.add_gradient(x, g);
  double slope = 0;
  for (std::size_t i = 0; i < n; ++i) slope += g[i].dot(d[i]);
  const double by_difference = (energy.value(moved(h)) - energy.value(moved(-h))) / (2 * h);
  particles::BlockPattern pattern(static_cast<int>(n));
  energy.add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix matrix(pattern);
  matrix.set_zero();
  energy.add_hessian(x, matrix, particles::HessianKind::exact);
  particles::VectorField hd(n, Vec3::Zero()), low(n, Vec3::Zero()), high(n, Vec3::Zero());
  matrix.add_product(d, hd);
  energy.add_gradient(moved(-h), low);
  energy.add_gradient(moved(h), high);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    error += (hd[i] - (high[i] - low[i]) / (2 * h)).squaredNorm();
    size += hd[i].squaredNorm();
  }
  fmt::print("slope {} by differences {}; Hessian off by {:.2g}\n", slope, by_difference,
             std::sqrt(error / size));
}

}  // namespace

int main(int argc, char** argv) {
  const double edge = option(argc, argv, "--edge", 10) * 1e-3;
  const double ease = option(argc, argv, "--ease", 0.15);
  const double bend = radians(option(argc, argv, "--bend", 44));
  const int steps = static_cast<int>(option(argc, argv, "--steps", 4));
  const std::string name = word(argc, argv, "--membrane", "cst");
  fabric::Material m;
  m.friction_body = option(argc, argv, "--friction", 0.2);
  scale_membrane(m, option(argc, argv, "--stretch", 1));
  m.stiffness_shear *= option(argc, argv, "--shear", 1);
  m.bending_warp *= option(argc, argv, "--bending", 1);
  m.bending_weft *= option(argc, argv, "--bending", 1);
  m.thickness = option(argc, argv, "--thickness", 0.5) * 1e-3;

  Arm arm;
  const double length = arm.length() * 0.97;
  const double w0 = 2 * kPi * arm.radius(0) * (1 + ease),
               w1 = 2 * kPi * arm.radius(length) * (1 + ease);
  // v runs up the arm from its end.
  const auto width = [&](double v) { return w1 + (w0 - w1) * v / length; };
  std::mt19937 random(static_cast<unsigned>(option(argc, argv, "--seed", 1)));
  std::uniform_real_distribution<double> bump(-2e-4, 2e-4);
  validate::Bench bench(
      validate::cut_specimen({{-w1 / 2, 0}, {w1 / 2, 0}, {w0 / 2, length}, {-w0 / 2, length}}, edge,
                             m, {{3, 1}}),
      m, [&](const Vec2& p) {
        const double round = -2 * kPi * p[0] / width(p[1]);
        return Vec3(arm.place(length - p[1], round + kPi, width(p[1]) / (2 * kPi), 0) +
                    Vec3(bump(random), bump(random), bump(random)));
      });
  const auto& specimen = bench.specimen();
  std::unique_ptr<bench::TrialMembrane> trial;
  const bool plain = name == "cst";
  trial =
      std::make_unique<bench::TrialMembrane>(specimen.triangles, specimen.triangle_uv, m,
                                             trial_named(name, option(argc, argv, "--share", 0.1)));
  if (!plain) bench.system().energies[0] = trial.get();
  if (word(argc, argv, "--check", "no") == "yes") {
    check(*trial, bench.x);
    return 0;
  }
  bench.hold(
      validate::vertices_where(specimen, [&](const Vec2& p) { return p[1] > length - 1e-6; }));

  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  Progress progress;
  int iterations = 0;
  double residual = 0;
  for (int step = 0; step <= steps; ++step) {
    const double before = bend * std::max(0, step - 1) / steps, now = bend * step / steps;
    if (step > 0)
      for (Vec3& p : bench.x) {
        const Vec3 a = arm.address(p, before);
        p = arm.place(a[0], a[1], a[2], now);
      }
    bench.touch(arm.body(now));
    const auto outcome =
        validate::settle_bench(bench, progress, step < steps ? 2e-2 : 1e-3, false, 600);
    iterations += outcome.work.iterations;
    residual = outcome.residual;
    if (step == steps) fmt::print(stderr, "{}\n", outcome.text());
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  // As maps read them: at vertices, means over the triangles round them.
  double at_vertices = 0, vertex_area = 0, vertex_shear = 0, vertex_warp = 0, vertex_weft = 0;
  {
    std::vector<double> greatest_of, shear_of, warp_of, weft_of;
    for (int t = 0; t < static_cast<int>(specimen.triangles.size()); ++t) {
      const auto f = maps::garment_gradient(specimen, t, bench.x);
      const auto e = maps::triangle_strain(f);
      greatest_of.push_back(e.max);
      warp_of.push_back(e.warp);
      weft_of.push_back(e.weft);
      shear_of.push_back(maps::trellis_shear(f));
    }
    const auto area = maps::vertex_areas(specimen);
    const auto shear = maps::to_vertices(specimen, shear_of),
               warp = maps::to_vertices(specimen, warp_of),
               weft = maps::to_vertices(specimen, weft_of);
    for (int v = 0; v < specimen.vertex_count; ++v) {
      const double up = specimen.vertex_uv[v][1];
      if (up > length - 0.03 || up < 0.02) continue;
      vertex_area += area[v];
      vertex_shear += area[v] * std::abs(degrees(shear[v]));
      vertex_warp += area[v] * std::abs(warp[v]);
      vertex_weft += area[v] * std::abs(weft[v]);
      // Principal strain of the mean deformation.
      const double a = 1 + warp[v], b = 1 + weft[v], c = a * b * std::sin(shear[v]);
      at_vertices +=
          area[v] * (std::sqrt(0.5 * (a * a + b * b) + std::hypot(0.5 * (a * a - b * b), c)) - 1);
    }
  }
  double sum = 0, warp = 0, weft = 0, shear = 0, greatest = 0, aw = 0, af = 0;
  double tw = 0, tf = 0;
  std::vector<double> angle;
  const auto strain = maps::triangle_strains(specimen, bench.x);
  const auto area = geometry::flat_areas(specimen.triangle_uv);
  for (std::size_t t = 0; t < strain.size(); ++t) {
    const auto& uv = specimen.triangle_uv[t];
    const double v = (uv[0][1] + uv[1][1] + uv[2][1]) / 3;
    if (v > length - 0.03 || v < 0.02) continue;
    sum += area[t];
    const auto f = maps::garment_gradient(specimen, static_cast<int>(t), bench.x);
    shear += area[t] * std::abs(degrees(maps::trellis_shear(f)));
    warp += area[t] * strain[t].warp;
    weft += area[t] * strain[t].weft;
    aw += area[t] * std::abs(strain[t].warp);
    af += area[t] * std::abs(strain[t].weft);
    greatest += area[t] * strain[t].max;
    const Vec3 e = trial->strain(static_cast<int>(t), bench.x);
    tw += area[t] * e[1];
    tf += area[t] * e[0];
  }
  std::vector<double> normal(bench.x.size(), 0.0);
  bench.cloth().body().add_normal_force(bench.x, normal);
  double force = 0, weight = 0;
  for (std::size_t i = 0; i < normal.size(); ++i)
    force += normal[i], weight += kGravity * specimen.vertex_mass[i];
  const auto& energies = bench.system().energies;
  fmt::print(
      "{{\"membrane\":\"{}\",\"edge\":{:g},\"particles\":{},\"iterations\":{},\"seconds\":{:.1f},"
      "\"cpu\":{:.1f},\"residual\":{:.2g},\"warp\":{:.3f},\"weft\":{:.3f},\"trial_warp\":{:.3f},"
      "\"trial_weft\":{:.3f},\"abs_warp\":{:.3f},\"abs_weft\":{:.3f},\"max\":{:.3f},\"shear_deg\":{"
      ":.3f},"
      "\"v_warp\":{:.3f},\"v_weft\":{:.3f},\"v_max\":{:.3f},\"v_shear\":{:.3f},\"force_weights\":{:"
      ".2f},\"membrane_uJ\":{:.1f},\"bending_uJ\":{:.1f}}}\n",
      name, 1e3 * edge, bench.x.size(), iterations, seconds,
      static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, residual, 100 * warp / sum,
      100 * weft / sum, 100 * tw / sum, 100 * tf / sum, 100 * aw / sum, 100 * af / sum,
      100 * greatest / sum, shear / sum, 100 * vertex_warp / vertex_area,
      100 * vertex_weft / vertex_area, 100 * at_vertices / vertex_area, vertex_shear / vertex_area,
      force / weight, 1e6 * energies[0]->value(bench.x), 1e6 * energies[1]->value(bench.x));
}
