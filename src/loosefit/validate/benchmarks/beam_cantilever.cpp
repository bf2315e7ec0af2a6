#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/types.h"
#include "loosefit/validate/cantilever.h"
#include "loosefit/validate/catalogue.h"

namespace loosefit::validate {
namespace {

struct HeavyRow {
  double gravity_number, w, h;  ///< Γ, W/L, H/L
};

// Heavy elastica θ″ = −Γ s cos θ by shooting: docs/theory/validation.md 4.1.
constexpr HeavyRow kHeavy[] = {
    {0.01, 0.99999911, 0.00125000}, {0.1, 0.99991073, 0.01249844},  {0.5, 0.99777900, 0.06230577},
    {1, 0.99124640, 0.12347140},    {2, 0.96689295, 0.23850658},    {3, 0.93151121, 0.33964839},
    {4, 0.89011075, 0.42515928},    {5, 0.84665718, 0.49590504},    {6, 0.80372530, 0.55392387},
    {8, 0.72442473, 0.64063072},    {10, 0.65635376, 0.70019972},   {15, 0.52956589, 0.78604289},
    {20, 0.44523205, 0.82988144},   {30, 0.34276368, 0.87309242},   {50, 0.24501476, 0.90791712},
    {100, 0.15922338, 0.93752394},  {200, 0.10742044, 0.95676920},  {500, 0.06589004, 0.97311700},
    {1000, 0.04598645, 0.98114127}, {2000, 0.03223768, 0.98673692}, {5000, 0.02024023, 0.99165087},
    {10000, 0.01426089, 0.99410993}};
constexpr HeavyRow kHeavyQuick[] = {{0.1, 0.99991073, 0.01249844},
                                    {1, 0.99124640, 0.12347140},
                                    {10, 0.65635376, 0.70019972},
                                    {100, 0.15922338, 0.93752394}};

struct ForceRow {
  double force_number, w, h;  ///< α, W/L, H/L
};

// Elastica under a dead tip load: docs/theory/validation.md 4.3 (α = 1: Bisshopp and Drucker 1945).
constexpr ForceRow kForce[] = {{0.1, 0.99933460, 0.03329532}, {0.25, 0.99588218, 0.08274592},
                               {0.5, 0.98408104, 0.16214358}, {1, 0.94356676, 0.30172077},
                               {2, 0.83935828, 0.49345748},   {3, 0.74557982, 0.60325344},
                               {5, 0.61237164, 0.71379152},   {10, 0.44500440, 0.81060902}};

/// Slope of log(error) over log(edge) by least squares: the order of convergence.
double order_of(const std::vector<double>& elements, const std::vector<double>& errors) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double x = -std::log(elements[i]), y = std::log(errors[i]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Refines one cantilever and reports how fast its end comes to its place. Ten edges are drawn but
/// not counted: there the stretch of flat triangles along a curve, of fourth order, prevails. At
/// Γ = 1, because errors of opposite sign meet at larger Γ (that of H/W vanishes near Γ = 15) and
/// hide the order.
void add_convergence(BenchmarkResult& result, Progress& progress, double from, double to) {
  constexpr HeavyRow kRow = {1, 0.99124640, 0.12347140};
  std::vector<double> elements, errors;
  report::Plot plot{"Refinement of the heavy cantilever at Γ = 1",
                    "edges along the length",
                    "distance of the end from its place over L",
                    true,
                    true,
                    {}};
  for (const int n : {10, 20, 40, 80}) {
    progress.update(from + (to - from) * elements.size() / 4, fmt::format("{} edges", n));
    const CantileverShape shape = settle_cantilever({kRow.gravity_number, 0, n, 0}, progress);
    elements.push_back(n);
    errors.push_back(std::hypot(shape.w - kRow.w, shape.h - kRow.h));
  }
  Finding f;
  f.what = "order of convergence at Γ = 1, from 20 to 80 edges along L";
  f.expected = 2;
  f.obtained = order_of({elements.begin() + 1, elements.end()}, {errors.begin() + 1, errors.end()});
  f.gate = Finding::Gate::absolute;
  f.limit = 0.5;
  f.mesh = "3 meshes";
  result.findings.push_back(f);
  plot.series.push_back({"second order", elements, {}, true});
  for (const double n : elements)
    plot.series[0].y.push_back(errors.back() * std::pow(elements.back() / n, 2));
  plot.series.push_back({"obtained", elements, errors, false});
  result.plots.push_back(plot);
}

}  // namespace

BenchmarkResult benchmark_heavy_cantilever(Effort effort, Progress& progress) {
  BenchmarkResult result;
  std::vector<HeavyRow> rows(std::begin(kHeavy), std::end(kHeavy));
  if (effort == Effort::quick) rows.assign(std::begin(kHeavyQuick), std::end(kHeavyQuick));
  report::Plot plot{"Cantilever under its own weight", "Γ = q L³/B", "H/W", true, true, {}};
  plot.series = {{"elastica", {}, {}, true}, {"obtained", {}, {}, false}};
  for (const HeavyRow& row : kHeavy) {
    plot.series[0].x.push_back(row.gravity_number);
    plot.series[0].y.push_back(row.h / row.w);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const HeavyRow& row = rows[i];
    progress.update(0.8 * i / rows.size(), fmt::format("Γ = {:g}", row.gravity_number));
    const int elements = cantilever_elements(row.gravity_number);
    const CantileverShape shape = settle_cantilever({row.gravity_number, 0, elements, 0}, progress);
    Finding f;
    f.what = fmt::format("H/W at Γ = {:g}", row.gravity_number);
    f.expected = row.h / row.w;
    f.obtained = shape.h / shape.w;
    f.limit = 0.01;
    f.mesh = fmt::format("{} edges along L, {}", elements, shape.mesh);
    result.findings.push_back(f);
    plot.series[1].x.push_back(row.gravity_number);
    plot.series[1].y.push_back(f.obtained);
  }
  result.plots.push_back(plot);
  if (effort == Effort::full) add_convergence(result, progress, 0.9, 1);
  result.notes = {
      "One cotton (120 g/m², B = 4.41e-6 N m, K = 2000 N/m, ν = 0) under ordinary gravity, cut to "
      "lengths from 3 mm to 33 cm; the strip starts straight. No constant differs from row to row.",
      "At least 40 edges along the length; where the weight bends the strip down within a short "
      "length √(B/(q L)) at the clamp, five edges within that length."};
  return result;
}

BenchmarkResult benchmark_overhang(Effort, Progress& progress) {
  BenchmarkResult result;
  const double degree = 180 / kPi;
  std::vector<int> meshes = {40, 80};
  for (const int n : meshes) {
    const CantileverShape shape = settle_cantilever({8, 0, n, 0}, progress);
    Finding f;
    f.what = "chord angle at an overhang of two bending lengths";
    f.unit = "°";
    f.expected = 41.487303;
    f.obtained = shape.chord_angle() * degree;
    f.gate = Finding::Gate::absolute;
    f.limit = 0.3;
    f.mesh = fmt::format("{} edges along L, {}", n, shape.mesh);
    result.findings.push_back(f);
    progress.update(0.5, "");
  }
  result.notes = {
      "The cantilever test of ASTM D1388 takes the overhang at 41.5° as twice the bending length. "
      "The exact elastica agrees with that rule (Γ = 8); Peirce's closed formula would give 5.8 % "
      "too much rigidity there."};
  return result;
}

BenchmarkResult benchmark_tip_load(Effort effort, Progress& progress) {
  BenchmarkResult result;
  report::Plot plot{"Cantilever with a load on its end", "α = P L²/B", "over L", false, false, {}};
  plot.series = {{"W/L, elastica", {}, {}, true},
                 {"H/L, elastica", {}, {}, true},
                 {"W/L, obtained", {}, {}, false},
                 {"H/L, obtained", {}, {}, false}};
  const auto add = [&](int k, double x, double y) {
    plot.series[k].x.push_back(x);
    plot.series[k].y.push_back(y);
  };
  int i = 0;
  for (const ForceRow& row : kForce) {
    add(0, row.force_number, row.w);
    add(1, row.force_number, row.h);
    const bool wanted = effort == Effort::full || row.force_number == 1 || row.force_number == 10;
    ++i;
    if (!wanted) continue;
    progress.update(i / 8.0, fmt::format("α = {:g}", row.force_number));
    const CantileverShape shape = settle_cantilever({0, row.force_number, 40, 0.1}, progress);
    add(2, row.force_number, shape.w);
    add(3, row.force_number, shape.h);
    for (const bool vertical : {false, true}) {
      Finding f;
      f.what = fmt::format("{}/L at α = {:g}", vertical ? "H" : "W", row.force_number);
      f.expected = vertical ? row.h : row.w;
      f.obtained = vertical ? shape.h : shape.w;
      f.limit = 0.01;
      f.mesh = fmt::format("40 edges along L, {}", shape.mesh);
      result.findings.push_back(f);
    }
  }
  result.plots.push_back(plot);
  result.notes = {
      "A weightless strip of 100 mm; the load stays vertical. A module of mass m on the "
      "edge of a strip of width b is P = m g/b."};
  return result;
}

}  // namespace loosefit::validate
