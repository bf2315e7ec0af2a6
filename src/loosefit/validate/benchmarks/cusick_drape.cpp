#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/drape_specimen.h"

namespace loosefit::validate {
namespace {

constexpr double kEdge = 0.008, kFineEdge = 0.0055;   ///< [m]
constexpr double kIsoShear = 150, kFabricShear = 30;  ///< [N/m]; K/2 and that of a woven fabric
constexpr double kHingePoisson = -1.0 / 3.0;  ///< of the hinge with which the reference was made

/// One row of the table of docs/theory/validation.md 5.3: DC of the reference for 5, 6 and 7 folds
/// on 8 mm edges, and the fold number of lowest energy.
struct Row {
  double c_cm;
  std::array<double, 3> iso;
  int iso_folds;
  double fabric;  ///< at its own fold number of lowest energy
  int fabric_folds;
};
const std::vector<Row>& table() {
  static const std::vector<Row> rows = {
      {1.00, {0.22, 0.23, 0.20}, 7, 0.17, 7}, {1.25, {0.31, 0.28, 0.28}, 7, 0.27, 7},
      {1.50, {0.38, 0.39, 0.41}, 7, 0.40, 7}, {2.00, {0.60, 0.63, 0.65}, 6, 0.57, 5},
      {2.50, {0.77, 0.78, 0.80}, 6, 0.73, 5}, {3.00, {0.85, 0.87, 0.88}, 5, 0.84, 5},
      {4.00, {0.95, 0.95, 0.95}, 5, 0.95, 5}, {5.00, {0.98, 0.98, 0.98}, 5, 0.98, 5},
  };
  return rows;
}

/// What the reference says is to be added for an infinitely fine mesh: 0.05, 0.03, 0.015 at 1.5,
/// 2.0, 2.5 cm. Held at 0.05 below 1.5 cm, straight between, nothing above, where it states none.
double mesh_correction(double c_cm) {
  if (c_cm <= 1.5) return 0.05;
  if (c_cm <= 2.0) return 0.05 - 0.04 * (c_cm - 1.5);
  if (c_cm <= 2.5) return 0.03 - 0.03 * (c_cm - 2.0);
  return 0;
}

double limit(double c_cm) { return c_cm < 1.75 ? 0.08 : 0.05; }

/// The reference's sheet of bending length c; only c matters, and weakly K
/// (docs/theory/validation.md 5.3).
fabric::Material sheet(double c_cm, double shear, double bending_poisson) {
  fabric::Material m;
  m.areal_density = 0.12;
  m.stiffness_warp = m.stiffness_weft = 300;
  m.poisson = 0;
  m.stiffness_shear = shear;
  m.bending_warp = m.bending_weft = m.areal_density * kGravity * std::pow(0.01 * c_cm, 3);
  m.bending_poisson = bending_poisson;
  return m;
}

struct Drapery {
  DrapeReading reading;
  std::string mesh;
  particles::VectorField x;
};

/// Counts its drapes for the progress bar.
class Tester {
 public:
  Tester(Progress& progress, int drapes) : progress_(progress), drapes_(drapes) {}

  Drapery drape(const fabric::Material& m, int folds, double edge, double tolerance = 1e-6) {
    ++done_;
    progress_.update(std::min(1.0, double(done_ - 1) / drapes_),
                     fmt::format("drape {} of {}", done_, drapes_));
    const DrapeTester tester;
    Bench bench(cut_drape_specimen(tester, edge, m), m, folded_start(tester, folds));
    bench.hold(on_disc(bench.specimen(), tester));
    settle_bench(bench, progress_, tolerance);
    touching_ += bench.cloth().self().active(bench.x) > 0;
    return {read_drape(bench, tester), mesh_text(bench.specimen()), bench.x};
  }

  /// The start of 5, 6, 7 folds that ends at the lowest energy.
  Drapery lowest(const fabric::Material& m, double edge) {
    Drapery best;
    for (int folds : {5, 6, 7}) {
      Drapery d = drape(m, folds, edge);
      if (folds == 5 || d.reading.energy < best.reading.energy) best = std::move(d);
    }
    return best;
  }

  /// How many drapes so far touch themselves.
  int touching() const { return touching_; }
  int done() const { return done_; }

 private:
  Progress& progress_;
  int drapes_, done_ = 0, touching_ = 0;
};

Finding finding(const std::string& what, double expected, const Drapery& d, double bound) {
  return {what, "", expected, d.reading.coefficient, Finding::Gate::absolute, bound, d.mesh};
}

/// Scaling w, B, K and G by one factor must not change the shape.
void scaling(Tester& tester, std::vector<Finding>& findings) {
  fabric::Material m = sheet(2.0, kIsoShear, kHingePoisson);
  const double edge = 0.012;
  const Drapery one = tester.drape(m, 6, edge, 1e-9);
  for (double* value : {&m.areal_density, &m.stiffness_warp, &m.stiffness_weft, &m.stiffness_shear,
                        &m.bending_warp, &m.bending_weft})
    *value *= 3.7;
  const Drapery other = tester.drape(m, 6, edge, 1e-9);
  double moved = 0;
  for (std::size_t i = 0; i < one.x.size(); ++i)
    moved = std::max(moved, (one.x[i] - other.x[i]).norm());
  findings.push_back({"largest difference in shape when w, B, K and G are scaled by 3.7", "mm", 0,
                      1e3 * moved, Finding::Gate::absolute, 1e-3, one.mesh});
}

void whole_table(Tester& tester, BenchmarkResult& result) {
  report::Plot plot{"Drape coefficient over bending length", "c [cm]", "DC", false, false, {}};
  report::Plot::Series iso_line{"reference, G = 150 N/m, converged", {}, {}, true};
  report::Plot::Series iso_marks{"obtained, ν = −1/3", {}, {}, false};
  report::Plot::Series zero_marks{"obtained, ν = 0", {}, {}, false};
  report::Plot::Series fabric_line{"reference, G = 30 N/m, converged", {}, {}, true};
  report::Plot::Series fabric_marks{"obtained, G = 30 N/m", {}, {}, false};
  const auto put = [](report::Plot::Series& s, double x, double y) {
    s.x.push_back(x), s.y.push_back(y);
  };
  std::vector<Finding> fabric, zero;
  for (const Row& row : table()) {
    const double add = mesh_correction(row.c_cm), bound = limit(row.c_cm);
    const Drapery iso = tester.lowest(sheet(row.c_cm, kIsoShear, kHingePoisson), kEdge);
    const double wanted = row.iso[row.iso_folds - 5] + add;
    const int folds = iso.reading.folds.count;
    result.findings.push_back(
        finding(fmt::format("DC at c = {:g} cm, lowest energy ({} folds, reference {})", row.c_cm,
                            folds, row.iso_folds),
                wanted, iso, bound));
    put(iso_line, row.c_cm, wanted);
    put(iso_marks, row.c_cm, iso.reading.coefficient);

    const Drapery soft = tester.lowest(sheet(row.c_cm, kFabricShear, kHingePoisson), kEdge);
    fabric.push_back(
        finding(fmt::format("DC at c = {:g} cm, G = 30 N/m, lowest energy ({} folds, reference {})",
                            row.c_cm, soft.reading.folds.count, row.fabric_folds),
                row.fabric + add, soft, bound));
    put(fabric_line, row.c_cm, row.fabric + add);
    put(fabric_marks, row.c_cm, soft.reading.coefficient);

    const Drapery plain = tester.drape(sheet(row.c_cm, kIsoShear, 0), folds, kEdge);
    zero.push_back(
        finding(fmt::format("DC at c = {:g} cm with ν = 0 in bending, {} folds", row.c_cm, folds),
                iso.reading.coefficient, plain, bound));
    zero.back().gate = Finding::Gate::reported;
    zero.back().limit = 0;
    put(zero_marks, row.c_cm, plain.reading.coefficient);
  }
  result.findings.insert(result.findings.end(), fabric.begin(), fabric.end());
  result.findings.insert(result.findings.end(), zero.begin(), zero.end());
  plot.series = {iso_line, iso_marks, zero_marks, fabric_line, fabric_marks};
  result.plots.push_back(plot);
}

void refinement(Tester& tester, BenchmarkResult& result) {
  for (double c : {1.5, 2.0, 2.5}) {
    const auto row =
        std::find_if(table().begin(), table().end(), [&](const Row& r) { return r.c_cm == c; });
    result.findings.push_back(finding(
        fmt::format("DC at c = {:g} cm, 6 folds, finer mesh", c), row->iso[1] + mesh_correction(c),
        tester.drape(sheet(c, kIsoShear, kHingePoisson), 6, kFineEdge), limit(c)));
  }
}

/// Cotton of Harms et al. 2012: c = 1.554 cm, K = 1000 N/m, ν = 0.15.
void paper_cotton(Tester& tester, BenchmarkResult& result) {
  fabric::Material m = sheet(1.554, 1000 / (2 * 1.15), kHingePoisson);
  m.stiffness_warp = m.stiffness_weft = 1000;
  m.poisson = 0.15;
  for (const auto& [folds, dc] : {std::pair{6, 0.46}, std::pair{7, 0.50}})
    result.findings.push_back(
        finding(fmt::format("DC of the 2012 paper's cotton (c = 1.554 cm), {} folds", folds),
                dc + mesh_correction(1.554), tester.drape(m, folds, kEdge), limit(1.554)));
}

}  // namespace

BenchmarkResult benchmark_cusick_drape(Effort effort, Progress& progress) {
  BenchmarkResult result;
  Tester tester(progress, effort == Effort::quick ? 3 : 7 * static_cast<int>(table().size()) + 7);
  if (effort == Effort::quick) {
    result.findings.push_back(finding("DC at c = 2 cm, 6 folds", 0.63 + mesh_correction(2.0),
                                      tester.drape(sheet(2.0, kIsoShear, kHingePoisson), 6, kEdge),
                                      limit(2.0)));
  } else {
    whole_table(tester, result);
    refinement(tester, result);
    paper_cotton(tester, result);
  }
  scaling(tester, result.findings);
  result.notes = {
      "Disc of 9 cm, specimen of 15 cm radius, clamped on the disc; K = 300 N/m, shear stiffness "
      "150 N/m unless stated, membrane ν = 0, w = 0.12 kg/m². The starts have 5, 6 and 7 folds; "
      "the one that settles at the lowest energy decides, as in the reference.",
      "Expected: the reference's table for 8 mm edges plus the correction it states for its own "
      "mesh error (0.05, 0.03, 0.015 at c = 1.5, 2.0, 2.5 cm; our reading: straight between, 0.05 "
      "below, none above). Gate 0.05, below c = 1.75 cm 0.08. The reference bends by hinges, "
      "which act as ν = −1/3, so that value is set here; ν = 0, the default, stands beside it "
      "against our own ν = −1/3.",
      fmt::format("The reference has no self contact. Here it is on as in every drape; {} of {} "
                  "drapes touch themselves.",
                  tester.touching(), tester.done())};
  return result;
}

}  // namespace loosefit::validate
