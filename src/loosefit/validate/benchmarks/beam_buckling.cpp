#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/types.h"
#include "loosefit/validate/beam_strip.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/stability.h"

namespace loosefit::validate {
namespace {

/// How a strip that stands on its clamp is loaded from above.
enum class Load { own_weight, end_force };

/// An upright strip: its straight state under a load, and whether that state is stable.
class Column {
 public:
  Column(Load load, int elements) : load_(load), fabric_(beam_fabric()), strip_(cut(elements)) {}

  double length() const { return strip_.length; }
  std::string mesh() const { return mesh_text(strip_.specimen); }

  /// Settles the straight strip under Γ = q L³/B or α = P L²/B, then asks the exact Hessian of all
  /// energies whether it is positive definite.
  bool stable(double load_number, Progress& progress) {
    const double l = strip_.length, b = fabric_.bending_weft;
    const bool heavy = load_ == Load::own_weight;
    Bench::Options options;
    options.gravity = heavy ? load_number * b / (l * l * l * fabric_.areal_density) : 0;
    const double force = heavy ? 0 : load_number * b / (l * l) * strip_.width;
    Bench bench(
        strip_.specimen, fabric_, [&](const Vec2& p) { return Vec3(0, p[1], p[0]); }, options);
    bench.hold(strip_.clamp);
    const std::vector<double> weight = line_weights(strip_.end, bench.flat());
    for (std::size_t i = 0; i < strip_.end.size(); ++i)
      if (!heavy) bench.loads().force[strip_.end[i]] = Vec3(0, 0, -force * weight[i]);
    settle_bench(bench, progress, heavy ? kBenchTolerance : kBenchTolerance * force);
    for (const Vec3& p : bench.x)
      if (std::abs(p[0]) > 1e-6 * l)
        throw SolverFailure(fmt::format("the strip left its plane at a load of {:g}", load_number));
    return is_stable(bench);
  }

  /// The load at which stability is lost, by bisection to 1e-5.
  double critical(double low, double high, Progress& progress) {
    if (!stable(low, progress) || stable(high, progress)) return std::nan("");
    while (high - low > 1e-5 * high) {
      const double middle = 0.5 * (low + high);
      (stable(middle, progress) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

 private:
  ClampedStrip cut(int elements) const {
    const double l = std::cbrt(8 * fabric_.bending_weft / (fabric_.areal_density * kGravity));
    return cut_clamped_strip(l, 6 * l / elements, l / elements, fabric_);
  }

  Load load_;
  fabric::Material fabric_;
  ClampedStrip strip_;
};

Finding critical_load(const std::string& what, Load load, double exact, int elements,
                      Progress& progress) {
  Column column(load, elements);
  Finding f;
  f.what = what;
  f.expected = exact;
  f.obtained = column.critical(0.7 * exact, 1.3 * exact, progress);
  f.limit = 0.02;
  f.mesh = fmt::format("{} edges along L, {}", elements, column.mesh());
  return f;
}

}  // namespace

BenchmarkResult benchmark_self_buckling(Effort effort, Progress& progress) {
  BenchmarkResult result;
  result.findings.push_back(critical_load("Γ of an upright strip under its own weight",
                                          Load::own_weight, 7.83734744, 40, progress));
  progress.update(0.3, "");
  if (effort == Effort::full) {
    result.findings.push_back(critical_load("Γ of an upright strip under its own weight",
                                            Load::own_weight, 7.83734744, 80, progress));
    progress.update(0.7, "");
    result.findings.push_back(critical_load("P L²/B of an upright strip with a load on its end",
                                            Load::end_force, kPi * kPi / 4, 40, progress));
  }
  result.notes = {
      "Method: the straight strip is settled under the load, its shortening included; it is stable "
      "as long as the exact second derivative of all its energies is positive definite (a Cholesky "
      "factorisation without shift succeeds). The load at which that ends is bisected to 1e-5. No "
      "imperfection is needed, and none is there.",
      "An end load that keeps its direction gives π²/4."};
  return result;
}

}  // namespace loosefit::validate
