#include <fmt/format.h>

#include <algorithm>

#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/drape_specimen.h"

namespace loosefit::validate {
namespace {

const DrapeTester kTester{0.5 * 0.127, 0.5 * 0.254};  ///< the Japanese drape tester
constexpr double kEdge = 0.0055, kQuickEdge = 0.011;  ///< [m]
constexpr int kLoweringSteps = 10;
constexpr double kWaviness = 0.01;  ///< slope of the flat specimen's imperfection [rad]

/// A fabric of docs/theory/validation.md 5.2 (Matsudaira, Masuda, Wada and Yokura 2015).
struct Fabric {
  std::string name;
  double bending;                   ///< B [N m]
  double loop;                      ///< 2HB [N]
  double measured;                  ///< drape coefficient
  double tolerance;                 ///< of docs/theory/validation.md 0
  std::array<double, 2> weight;     ///< assumed range of w, heavy first [kg/m²]
  std::array<double, 2> reference;  ///< elastic drape coefficients of 5.2 at these weights
};
const std::vector<Fabric>& fabrics() {
  static const std::vector<Fabric> all = {
      {"cotton broad", 1.15718e-5, 1.21602e-3, 0.829, 0.10, {0.13, 0.10}, {0.68, 0.73}},
      {"polyester faille", 1.86326e-6, 6.86466e-5, 0.283, 0.07, {0.11, 0.08}, {0.27, 0.34}}};
  return all;
}

fabric::Material material_of(const Fabric& fabric, double weight, bool friction) {
  fabric::Material m;
  m.areal_density = weight;
  m.thickness = 3e-4;
  m.stiffness_warp = m.stiffness_weft = 500;
  m.poisson = 0;
  m.stiffness_shear = 30;
  m.bending_warp = m.bending_weft = fabric.bending;
  if (friction) m.bending_hysteresis_warp = m.bending_hysteresis_weft = 0.5 * fabric.loop;
  return m;
}

struct Reading {
  DrapeReading drape;
  std::string mesh;
};

/// Settles a start with given folds under full weight at once.
Reading settle_folded(const fabric::Material& m, int folds, double edge, Progress& progress) {
  Bench bench(cut_drape_specimen(kTester, edge, m), m, folded_start(kTester, folds));
  bench.hold(on_disc(bench.specimen(), kTester));
  settle_bench(bench, progress);
  return {read_drape(bench, kTester), mesh_text(bench.specimen())};
}

Reading elastic(const fabric::Material& m, double edge, Progress& progress) {
  const Reading six = settle_folded(m, 6, edge, progress);
  const Reading seven = settle_folded(m, 7, edge, progress);
  return six.drape.energy < seven.drape.energy ? six : seven;
}

/// From the flat specimen, wavy by a fraction of a millimetre, whose weight is let on in equal
/// steps: the plate that held it level is lowered.
Reading lower(const fabric::Material& m, double edge, Progress& progress) {
  Bench bench(cut_drape_specimen(kTester, edge, m), m, folded_start(kTester, 6, 0, kWaviness));
  const Specimen& cloth = bench.specimen();
  bench.hold(on_disc(cloth, kTester));
  for (int step = 1; step <= kLoweringSteps; ++step) {
    const double carried = 1 - double(step) / kLoweringSteps;
    for (int v = 0; v < cloth.vertex_count; ++v)
      bench.loads().force[v] = Vec3(0, 0, carried * cloth.vertex_mass[v] * kGravity);
    settle_bench(bench, progress, 1e-4);
  }
  return {read_drape(bench, kTester), mesh_text(cloth)};
}

Finding& add(BenchmarkResult& result, const std::string& what, double expected, double tolerance,
             const Reading& r) {
  Finding f;
  f.what = fmt::format("{} ({} folds)", what, r.drape.folds.count);
  f.expected = expected;
  f.obtained = r.drape.coefficient;
  f.gate = Finding::Gate::absolute;
  f.limit = tolerance;
  f.mesh = r.mesh;
  return result.findings.emplace_back(std::move(f));
}

const KnownMiss kTooLimp = {0.15,
                            "without its bending friction this cotton is too limp, as "
                            "docs/theory/validation.md 5.2 expects: "
                            "the KES rigidity is the slope between the branches of the loop, and "
                            "what holds the cloth up is "
                            "the loop's width (2.3)"};
const KnownMiss kAtTheLightEnd = {0.13,
                                  "the weight is not in the source; at the light end of the range "
                                  "assumed for it the elastic sheet "
                                  "already lies above the measurement, and bending friction of a "
                                  "specimen lowered from flat adds to "
                                  "it"};
const KnownMiss kLightSheet = {0.07,
                               "the lightest sheet hangs too wide since cloth buckles below the "
                               "mesh (decision 17); the other three lie within the gate, and why "
                               "this one does not is not known"};

}  // namespace

BenchmarkResult benchmark_measured_fabrics(Effort effort, Progress& progress) {
  BenchmarkResult result;
  if (effort == Effort::quick) {
    const Fabric& cotton = fabrics()[0];
    add(result, "cotton broad, w = 0.13 kg/m²: lowered, with bending friction", cotton.measured,
        cotton.tolerance, lower(material_of(cotton, 0.13, true), kQuickEdge, progress));
  } else {
    report::Plot plot{"Drape of two measured fabrics over the assumed weight",
                      "w [kg/m²]",
                      "DC",
                      false,
                      false,
                      {}};
    int done = 0;
    for (const Fabric& f : fabrics()) {
      report::Plot::Series measured{f.name + ", measured", {}, {}, true},
          plain{f.name + ", elastic", {}, {}}, rubbing{f.name + ", with bending friction", {}, {}};
      for (int k : {0, 1}) {
        const double w = f.weight[k];
        const std::string who = fmt::format("{}, w = {:g} kg/m²", f.name, w);
        progress.update(done++ / 4.0, who);
        const Reading smooth = elastic(material_of(f, w, false), kEdge, progress);
        const Reading rough = lower(material_of(f, w, true), kEdge, progress);
        const bool light_end = f.name == "polyester faille" && k == 1;
        Finding& sheet_miss = add(result, who + ": elastic, against the reference's elastic sheet",
                                  f.reference[k], 0.05, smooth);
        if (light_end) sheet_miss.known_miss = kLightSheet;
        Finding& plain_miss = add(result, who + ": elastic, against the measurement", f.measured,
                                  f.tolerance, smooth);
        if (f.name == "cotton broad" && k == 0) plain_miss.known_miss = kTooLimp;
        if (light_end) plain_miss.known_miss = kAtTheLightEnd;
        Finding& rough_miss =
            add(result, who + ": lowered with bending friction, against the measurement",
                f.measured, f.tolerance, rough);
        if (light_end) rough_miss.known_miss = kAtTheLightEnd;
        if (k == 0)
          add(result, who + ": with bending friction, but from a folded start", f.measured,
              f.tolerance, settle_folded(material_of(f, w, true), 6, kEdge, progress));
        for (auto* s : {&measured, &plain, &rubbing}) s->x.push_back(w);
        measured.y.push_back(f.measured);
        plain.y.push_back(smooth.drape.coefficient);
        rubbing.y.push_back(rough.drape.coefficient);
      }
      for (const auto& s : {measured, plain, rubbing}) plot.series.push_back(s);
    }
    result.plots.push_back(plot);
  }
  result.notes = {
      "B and 2HB are measured (KES); the weights are assumed, 0.10 to 0.13 kg/m² for the cotton "
      "and "
      "0.08 to 0.11 for the faille, and so are K = 500 and G = 30 N/m and the disc of 12.7 under "
      "the specimen of 25.4 cm. The gates, ±10 points (cotton), ±7 (faille) and ±5 against the "
      "elastic sheets of the reference, are as wide as that.",
      fmt::format(
          "Bending friction remembers. The specimen lies flat, wavy by {:.1f} mm, and its "
          "weight is let on in {} equal steps, as when the plate under it is lowered; every "
          "step settles with the friction of the one before. Put into folds first and "
          "released, the same cloth hangs deeper.",
          1e3 * kWaviness * (kTester.specimen_radius - kTester.disc_radius), kLoweringSteps),
      "The elastic sheets start with 6 and 7 folds and the lower energy decides, as in the "
      "reference; ν = 0 in bending."};
  return result;
}

}  // namespace loosefit::validate
