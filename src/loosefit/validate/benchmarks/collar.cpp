#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/base/progress_part.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/maps/pressure.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/simulation_options.h"
#include "loosefit/pipeline/wearer_movements.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/other_bodies.h"
#include "loosefit/validate/worn_drapes.h"

// AG10 of docs/theory/air_gap.md 3: what carries a shirt, the side of the neck or the shoulder
// point.
namespace loosefit::validate {
namespace {

constexpr double kEdge = 0.014;  ///< [m]
constexpr double kWeight =
    0.30;  ///< areal density that makes the shirt one of 200 to 300 g [kg/m²]
constexpr double kWider = 0.010;  ///< of the neckline, to each side [m]
constexpr double kLeastPeak = 1;  ///< [Pa]
constexpr double kProbe = 0.012;  ///< radius over which pressure is read [m]
constexpr double kNear = 0.035;   ///< of a landmark, where its peak is looked for [m]

const char* const kSlope =
    "why is not known. What is seen: worn in, the shirt hangs from the shoulder beside the neck "
    "under either neckline, at pressures of 0.2 to 0.9 kPa; just put on, with a shoulder seam 4° "
    "steeper, normal shoulders had 0.3 under the wider one. The source does not tell the seam of "
    "its shirt";

struct Shoulders {
  const char* name;
  double more;          ///< slope, against the body of the model [rad]
  double missed;        ///< by which the neckline at the neck is known to miss its gate; 0: not
  double missed_wider;  ///< the same of the wider one
};
const Shoulders kShoulders[] = {
    {"sloping", radians(6.0), 0, 0}, {"normal", 0, 0, 4.5}, {"square", radians(-6.0), 0, 0}};

/// Largest pressure near the sides of the neck and near the shoulder points [Pa].
struct Peaks {
  double neck = 0, shoulder = 0, mass = 0;
};

Peaks peaks_of(const Shoulders& shoulders, double neck_ease, Progress& progress,
               std::string& mesh_text) {
  const scenario::Scenario scenario = [&] {
    scenario::Scenario s = worn_scenario(
        "sex = \"female\"\nheight = 1.62\nmeasurements = { chest = 0.86, waist = 0.70, hip = 0.92 "
        "}",
        fmt::format("fit = {{ chest = 0.15, hip = 0.12, neck_ease = {:.6f} }}", neck_ease), kEdge,
        1);
    s.studied().material.material.areal_density = kWeight;
    return s;
  }();
  const pipeline::CaseBody model = pipeline::make_body(scenario.body);
  const body::PosedBody wearer(with_shoulder_slope(model.body, shoulders.more));
  // The model's movements are sloped as all its bodies are: they begin and end where it stands.
  drape::Movements movements = pipeline::movements_of(model.body, model.person, model.to,
                                                      pipeline::usual_movements(scenario.donning));
  for (drape::Movement& movement : movements)
    movement.way = sloped_way(movement.way, shoulders.more);
  const auto garments = pipeline::mesh_garments(scenario, pipeline::make_patterns(scenario, wearer),
                                                {}, pipeline::MeshLevels::all);
  drape::DrapeSession session(pipeline::cloth_layers(scenario, garments),
                              pipeline::drape_options(scenario.simulation), progress);
  const drape::Drape drape =
      session.put_on(sloped_way(model.path, shoulders.more),
                     sloped_way(model.wide_path, shoulders.more), std::move(movements));
  if (!drape.certificate.settled())
    throw SolverFailure(std::string(shoulders.name) +
                        " shoulders: it did not settle: " + drape.certificate.stop_reason);
  const garment::Garment& mesh = garments.back().mesh();
  require_worn(mesh, garments.back().pattern.pattern, drape.positions, wearer,
               std::string(shoulders.name) + " shoulders");
  mesh_text = fmt::format("{:g} mm edges, {} triangles", 1e3 * kEdge, mesh.triangles.size());
  const maps::PressureField field =
      maps::contact_pressure(mesh, drape, wearer, scenario.studied().material.material);
  // Force in a probe over the cloth in it.
  const auto read = [&](const Vec3& place) {
    double force = 0, area = 0;
    for (int v = 0; v < mesh.vertex_count; ++v)
      if ((drape.positions[v] - place).norm() < kProbe)
        force += field.contact[v] * field.area[v], area += field.area[v];
    return area > 0 ? force / area : 0;
  };
  const auto peak_at = [&](const char* landmark) {
    double most = 0;
    for (const char* side : {"_L", "_R"}) {
      const Vec3& place = wearer->landmarks.at(std::string(landmark) + side);
      for (int v = 0; v < mesh.vertex_count; ++v)
        if ((drape.positions[v] - place).norm() < kNear)
          most = std::max(most, read(drape.positions[v]));
    }
    return most;
  };
  return {peak_at("hps"), peak_at("acromion"), mesh.mass};
}

}  // namespace

BenchmarkResult benchmark_collar(Effort, Progress& progress) {
  BenchmarkResult result;
  std::string mesh;
  int part = 0;
  const body::Body plain =
      pipeline::make_body(worn_scenario("sex = \"female\"\nheight = 1.62\n"
                                        "measurements = { chest = 0.86, waist = "
                                        "0.70, hip = 0.92 }",
                                        "", kEdge, 1)
                              .body)
          .body;
  // A share of the neck's width: what makes it wider by kWider at each side.
  const double wider = kWider / plain.landmarks.at("hps_L").x();
  for (const bool wide : {false, true})
    for (const Shoulders& shoulders : kShoulders) {
      ProgressPart own(progress, part / 6.0, 1 / 6.0);
      ++part;
      const Peaks peaks = peaks_of(shoulders, wide ? wider : 0, own, mesh);
      // Without pressure at both places nothing carries the shirt: no gate is met by that.
      const bool carried = std::max(peaks.neck, peaks.shoulder) >= kLeastPeak;
      const double ratio = carried ? peaks.neck / std::max(peaks.shoulder, kLeastPeak) : NAN;
      const std::string what = fmt::format(
          "AG10: {} shoulders, neckline {}: pressure at the neck over "
          "that at the shoulder point",
          shoulders.name, wide ? "10 mm wider" : "at the neck");
      // Sloping shoulders with the wider neckline: the source does not say.
      if (wide && shoulders.more > 0)
        result.findings.push_back(
            {what, "", std::nan(""), ratio, Finding::Gate::reported, 0, mesh});
      else
        result.findings.push_back(
            in_range(what, "", std::nan(""), ratio, wide ? 0 : 1, wide ? 1 : HUGE_VAL, mesh));
      if (const double missed = wide ? shoulders.missed_wider : shoulders.missed; missed > 0)
        result.findings.back().known_miss = KnownMiss{missed, kSlope};
      result.notes.push_back(fmt::format(
          "{} shoulders, neckline {}: {:.2f} kPa at the neck, {:.2f} kPa at the shoulder point; a "
          "shirt of {:.0f} g.",
          shoulders.name, wide ? "10 mm wider" : "at the neck", peaks.neck / 1000,
          peaks.shoulder / 1000, 1000 * peaks.mass));
    }
  result.notes.push_back(fmt::format(
      "Peaks of the mean pressure over discs of {:g} mm radius within {:g} mm of the landmark; "
      "shoulders of the body sloped by 6° to either side. Worn in. Source and order: "
      "docs/theory/air_gap.md 1 (R11).",
      1e3 * kProbe, 1e3 * kNear));
  return result;
}

}  // namespace loosefit::validate
