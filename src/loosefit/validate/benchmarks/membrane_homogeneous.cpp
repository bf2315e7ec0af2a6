#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "loosefit/fabric/stress_curve.h"
#include "loosefit/io/material_file.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/membrane_specimen.h"

// M1: homogeneous strain on an irregular mesh against the continuum law
// (docs/theory/validation.md 1.3 a).
namespace loosefit::validate {
namespace {

constexpr double kWidth = 0.1, kHeight = 0.12, kEdge = 0.01;  // [m]
constexpr double kGate = 1e-9;

/// A material law in closed form: (E_uu, E_vv, γ) to (S_uu, S_vv, S_uv) [N/m].
struct Law {
  std::string name;
  fabric::Material material;
  std::function<Vec3(const Vec3&)> stress;
};

Law linear_law() {
  const fabric::Material m = orthotropic_fabric();
  const double plate = 1 - m.poisson * m.poisson, ku = m.stiffness_weft, kv = m.stiffness_warp;
  Mat3 c = Mat3::Zero();
  c(0, 0) = ku / plate;
  c(1, 1) = kv / plate;
  c(0, 1) = c(1, 0) = m.poisson * std::sqrt(ku * kv) / plate;
  c(2, 2) = m.stiffness_shear;
  return {"St. Venant-Kirchhoff", m, [c](const Vec3& e) -> Vec3 { return c * e; }};
}

Law engineering_law() {
  const fabric::Material m = engineering_fabric();
  const auto force = [](double k, double e) {
    const double stretch = std::sqrt(1 + 2 * e);
    return e > 0 ? k * (stretch - 1) / stretch : k * e;
  };
  const double ku = orthotropic_fabric().stiffness_weft, kv = orthotropic_fabric().stiffness_warp;
  const double g = m.stiffness_shear;
  return {"measured curve f = K (λ − 1)", m, [=](const Vec3& e) -> Vec3 {
            return {force(ku, e[0]), force(kv, e[1]), g * e[2]};
          }};
}

Mat2 piola(const Law& law, const Mat2& f) {
  const Mat2 e = 0.5 * (f.transpose() * f - Mat2::Identity());
  const Vec3 s = law.stress({e(0, 0), e(1, 1), 2 * e(0, 1)});
  Mat2 stress;
  stress << s[0], s[2], s[2], s[1];
  return f * stress;
}

/// A patch under test and what its border forces say.
class Patch {
 public:
  explicit Patch(const fabric::Material& material)
      : bench_(
            rough(material), material, [](const Vec2& p) { return Vec3(p[0], p[1], 0); },
            weightless()) {}

  /// First Piola-Kirchhoff stress [N/m] from the border forces, Σ f_i X_iᵀ / area, with the patch
  /// strained by f and turned in space; `unbalance` is the largest force on an inner vertex [N].
  Mat2 stress(const Mat2& f, double& unbalance) {
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(0.2, 1, 0.4).normalized()).toRotationMatrix();
    const std::vector<Vec2>& flat = bench_.flat();
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const Vec2 p = f * flat[i];
      bench_.x[i] = turn * Vec3(p[0], p[1], 0);
    }
    const particles::VectorField force = bench_.system().gradient(bench_.x);
    Mat2 sum = Mat2::Zero();
    unbalance = 0;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const Vec2& p = flat[i];
      const bool border = std::min({p[0], p[1], kWidth - p[0], kHeight - p[1]}) < 1e-9;
      if (!border) unbalance = std::max(unbalance, force[i].norm());
      if (border) sum += (turn.transpose() * force[i]).head<2>() * p.transpose();
    }
    return sum / (kWidth * kHeight);
  }
  std::string mesh() const { return mesh_text(bench_.specimen()); }

 private:
  static Specimen rough(const fabric::Material& material) {
    Specimen s = cut_rectangle(kWidth, kHeight, kEdge, material);
    roughen(s, kEdge);
    return s;
  }
  static Bench::Options weightless() {
    Bench::Options options;
    options.gravity = 0;
    return options;
  }
  Bench bench_;
};

struct Motion {
  std::string name;
  std::function<Mat2(double)> gradient;  // of a strain in [0, 0.5]
  int row, column;                       // component of P that is told
};

Mat2 matrix(double a, double b, double c, double d) {
  Mat2 m;
  m << a, b, c, d;
  return m;
}

std::vector<Motion> motions() {
  return {
      {"weft stretch", [](double s) { return matrix(1 + s, 0, 0, 1); }, 0, 0},
      {"warp stretch", [](double s) { return matrix(1, 0, 0, 1 + s); }, 1, 1},
      {"equal stretch both ways", [](double s) { return matrix(1 + s, 0, 0, 1 + s); }, 1, 1},
      {"simple shear", [](double s) { return matrix(1, s, 0, 1); }, 0, 1},
  };
}

void run_motion(Patch& patch, const Law& law, const Motion& motion, BenchmarkResult& result,
                report::Plot::Series& obtained) {
  double worst = 0;
  Finding at_half;
  for (int i = 1; i <= 10; ++i) {
    const double strain = 0.05 * i;
    const Mat2 f = motion.gradient(strain), expected = piola(law, f);
    double unbalance = 0;
    const Mat2 p = patch.stress(f, unbalance);
    worst = std::max(
        {worst, (p - expected).norm() / expected.norm(), unbalance / (expected.norm() * kEdge)});
    at_half.expected = expected(motion.row, motion.column);
    at_half.obtained = p(motion.row, motion.column);
    obtained.x.push_back(100 * strain);
    obtained.y.push_back(at_half.obtained);
  }
  at_half.what = fmt::format("{}, {}: edge force at 50 %", law.name, motion.name);
  at_half.unit = "N/m";
  at_half.limit = kGate;
  at_half.mesh = patch.mesh();
  result.findings.push_back(at_half);
  Finding all;
  all.what =
      fmt::format("{}, {}: largest error of stress and balance, 5 to 50 %", law.name, motion.name);
  all.obtained = worst;
  all.gate = Finding::Gate::absolute;
  all.limit = kGate;
  all.mesh = patch.mesh();
  result.findings.push_back(all);
}

void run_law(const Law& law, BenchmarkResult& result) {
  Patch patch(law.material);
  report::Plot plot{
      law.name + " on an irregular mesh", "strain (%)", "edge force (N/m)", false, false, {}};
  for (const Motion& motion : motions()) {
    report::Plot::Series reference{motion.name + ", law", {}, {}, true},
        obtained{motion.name, {}, {}, false};
    for (int i = 0; i <= 50; ++i) {
      reference.x.push_back(i);
      reference.y.push_back(piola(law, motion.gradient(0.01 * i))(motion.row, motion.column));
    }
    run_motion(patch, law, motion, result, obtained);
    plot.series.push_back(std::move(reference));
    plot.series.push_back(std::move(obtained));
  }
  result.plots.push_back(std::move(plot));
}

// The wool card at its own measured points: what was typed in comes out.
void run_wool(BenchmarkResult& result) {
  const fabric::Material wool = io::load_material("wool-measured").material;
  Patch patch(wool);
  double worst[3] = {0, 0, 0}, unbalance = 0;
  for (const fabric::CurvePoint& p : wool.curve_weft)
    worst[0] = std::max(
        worst[0],
        std::abs(patch.stress(matrix(1 + p.strain, 0, 0, 1), unbalance)(0, 0) / p.force - 1));
  for (const fabric::CurvePoint& p : wool.curve_warp)
    worst[1] = std::max(
        worst[1],
        std::abs(patch.stress(matrix(1, 0, 0, 1 + p.strain), unbalance)(1, 1) / p.force - 1));
  for (const fabric::CurvePoint& p : wool.curve_shear) {
    // Weft at rest and warp turned by the shear at its rest length: only γ strains.
    const double c = std::sqrt(1 - p.strain * p.strain);
    const Mat2 f = matrix(1, p.strain, 0, c);
    const Mat2 s = f.inverse() * patch.stress(f, unbalance);
    worst[2] = std::max(worst[2], std::abs(s(0, 1) / p.force - 1));
  }
  const char* names[] = {"weft", "warp", "shear"};
  for (int i = 0; i < 3; ++i) {
    Finding f;
    f.what = fmt::format("measured wool, {}: largest error at its 7 measured points", names[i]);
    f.obtained = worst[i];
    f.gate = Finding::Gate::absolute;
    f.limit = kGate;
    f.mesh = patch.mesh();
    result.findings.push_back(f);
  }
}

}  // namespace

BenchmarkResult benchmark_homogeneous_strain(Effort, Progress& progress) {
  BenchmarkResult result;
  run_law(linear_law(), result);
  progress.update(0.4, "St. Venant-Kirchhoff");
  progress.check_cancelled();
  run_law(engineering_law(), result);
  progress.update(0.8, "measured curves");
  progress.check_cancelled();
  run_wool(result);
  result.notes.push_back(
      "The patch is strained and turned in space by a given gradient; the stress is that of the "
      "forces on its border, sum of f X^T over area. A constant-strain triangle is exact for "
      "homogeneous strain, so the error is round-off; the paper claims 1 % up to 50 %.");
  return result;
}

}  // namespace loosefit::validate
