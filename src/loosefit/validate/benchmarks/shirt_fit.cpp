#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/progress_part.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/trunk_hem.h"
#include "loosefit/validate/worn_drapes.h"

// Whether a shirt that is drafted to be loose is one on its wearer.
namespace loosefit::validate {
namespace {

constexpr double kMostWeights = 5;          ///< normal force free of the arms over weight [–]
constexpr double kLeastEase = 0.08 - 1e-6;  ///< at any station of trunk and arm [–]
constexpr double kLeastSleeveEase = 0.20;   ///< at elbow and forearm [–]
constexpr double kHemRange = 10;            ///< highest place of the hem over the lowest [mm]
constexpr double kLeastContact = 0.97;      ///< of the area round pressed corners [–]
/// By which the field may have come to err since its error was last measured, where force acts [m].
constexpr double kFieldDrift = 5e-5;
constexpr double kRoundOff = 1e-9;  ///< of a length
constexpr int kDonnings = 3;

struct Wearer {
  const char *who, *body, *more;
  double edge;  ///< [m]
  /// By so much ease [–], level of the hem [mm] and contact [–] are known to miss their gates; 0:
  /// they do not.
  double ease_missed, hem_missed, contact_missed;
};
/// The reference shirt, and the same ease on two other builds. Women's have half a bust dart.
const Wearer kWearers[] = {{"woman of 0.88 m chest",
                            "sex = \"female\"\nage = 30\nheight = 1.68\n"
                            "measurements = { chest = 0.88, waist = 0.72, hip = 0.97 }",
                            ", bust_dart = 0.5", 0.010, 0.003, 0, 0.28},
                           {"woman of 1.04 m chest",
                            "sex = \"female\"\nage = 50\nheight = 1.63\n"
                            "measurements = { chest = 1.04, waist = 0.92, hip = 1.10 }",
                            ", bust_dart = 0.5", 0.014, 0, 0, 0.46},
                           {"man of 1.00 m chest",
                            "sex = \"male\"\nage = 35\nheight = 1.78\n"
                            "measurements = { chest = 1.00, waist = 0.86, hip = 1.00 }",
                            "", 0.014, 0, 2.2, 0.40}};

const char* const kUnderarm =
    "10 % are cut round the underarm, which lies 1 to 2 cm over the level of the chest: there the "
    "body, arms aside, is 2 % wider than its chest is";
const char* const kBackHangs =
    "why is not known. What is seen, on six men of 0.92 to 1.10 m chest at 16 mm edges: sides hang "
    "5 to 14 mm over the lowest place; the back hangs 7 to 14 mm under the front where shoulders "
    "slope by 0.34 to 0.37, and 3 to 4 mm over it by 0.41. On six women, same edges, all is within "
    "7 mm";
const char* const kPeeling =
    "cloth peels off within a triangle of which a corner is pressed, and the corners of a flat "
    "triangle that touches a round limb stand off it by up to the height of its chord, h²κ/8: "
    "0.4 mm at 10 mm edges on a forearm, 0.8 mm at 14 mm "
    "(docs/decisions/0013-contact-sees-the-skin.md)";

/// Mean height of the hem at its places over the donnings [m].
HemHeights hem_heights(const std::vector<WornDrape>& drapes) {
  HemHeights mean = {};
  for (const WornDrape& worn : drapes) {
    const std::vector<Vec3>& x = worn.drape.positions;
    std::vector<double> height(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) height[v] = x[v].z();
    const HemHeights here = hem_means(trunk_hem(worn.mesh, x), x, height);
    for (int k = 0; k < kHemPlaces; ++k) mean[k] += here[k] / static_cast<double>(drapes.size());
  }
  return mean;
}

int stable_ones(const std::vector<WornDrape>& drapes) {
  return static_cast<int>(std::count_if(drapes.begin(), drapes.end(), [](const WornDrape& worn) {
    return worn.drape.certificate.stable.value_or(false);
  }));
}

/// How the cloth is held off the skin, in the donning with most of it.
struct HeldOff {
  double triangles = 0;  ///< of all [%]
  double distance = 0;   ///< at which contact lets the cloth's middle surface rest, largest [mm]
};

HeldOff held_off(const std::vector<WornDrape>& drapes) {
  HeldOff most;
  for (const WornDrape& worn : drapes) {
    const auto& report = worn.drape.report;
    most.triangles = std::max(most.triangles, 100.0 * report.held_off_triangles /
                                                  static_cast<double>(worn.mesh.triangles.size()));
    most.distance = std::max(most.distance, 1e3 * report.largest_contact_offset);
  }
  return most;
}

/// SettleReport::bearing_distance, the largest of the donnings [m]; NaN where nothing bears.
double farthest_bearing(const std::vector<WornDrape>& drapes) {
  double farthest = 0;
  for (const WornDrape& worn : drapes) {
    if (!worn.drape.report.bearing_distance) return NAN;
    farthest = std::max(farthest, *worn.drape.report.bearing_distance);
  }
  return farthest;
}

}  // namespace

BenchmarkResult benchmark_shirt_fit(Effort, Progress& progress) {
  BenchmarkResult result;
  const double share = 1.0 / std::size(kWearers);
  double done = 0;
  for (const Wearer& wearer : kWearers) {
    ProgressPart own(progress, done, share);
    done += share;
    const pipeline::CaseResult worn =
        wear(worn_scenario(wearer.body,
                           fmt::format("fit = {{ chest = 0.10, hip = 0.08, sleeve = 0.25, "
                                       "wrist = 0.25{} }}",
                                       wearer.more),
                           wearer.edge, kDonnings),
             wearer.who, own);
    const std::string mesh = fmt::format("{:g} mm edges, {} triangles", 1e3 * wearer.edge,
                                         worn.studied().mesh().triangles.size());
    const auto add = [&](const std::string& what, const std::string& unit, double obtained,
                         double low, double high, double missed = 0, const char* why = "") {
      result.findings.push_back(
          in_range(fmt::format("{}: {}", wearer.who, what), unit, NAN, obtained, low, high, mesh));
      if (missed > 0) result.findings.back().known_miss = KnownMiss{missed, why};
    };
    const std::vector<WornDrape> drapes = worn_drapes(worn);
    result.findings.push_back(
        whole_count(fmt::format("{}: donnings that are worn and at a stable balance, of {}",
                                wearer.who, kDonnings),
                    kDonnings, stable_ones(drapes), mesh));
    const std::optional<maps::BodyLoad>& load = worn.studied().maps.load;
    if (!load)
      throw SolverFailure(fmt::format("{}: the drape does not know its forces", wearer.who));
    add("normal force over weight, without what is squeezed between arm and trunk", "",
        load->free_force() / load->weight, 0, kMostWeights);
    const auto stations =
        pipeline::station_eases(worn.studied().pattern, worn.scenario.studied().spec);
    const auto least = pipeline::least_cut_ease(stations);
    add(least ? fmt::format("least ease as cut ({})", least->name) : "least ease as cut", "",
        least ? least->cut : NAN, kLeastEase, HUGE_VAL, wearer.ease_missed, kUnderarm);
    for (const char* name : {"sleeve at the elbow", "sleeve at the forearm"}) {
      const auto at = std::ranges::find(stations, name, &pipeline::StationEase::name);
      add(fmt::format("least ease as cut, {}", name), "", at == stations.end() ? NAN : at->cut,
          kLeastSleeveEase, HUGE_VAL);
    }
    const maps::ContactShare& contact = worn.studied().maps.pressure.contact_share;
    add("share of triangles with a pressed corner, by area, within the contact tolerance", "",
        contact.of_places, kLeastContact, 1, wearer.contact_missed, kPeeling);
    result.findings.push_back(
        {fmt::format("{}: the same, of triangles that are so somewhere", wearer.who), "", NAN,
         contact.of_triangles, Finding::Gate::reported, 0, mesh});
    const double half_thickness = drapes.front().half_thickness();
    add("distance of the middle surface from the skin within which 97 % of the area that bears "
        "force lies",
        "mm", 1e3 * farthest_bearing(drapes), 0, 1e3 * (half_thickness + kFieldDrift));
    const HeldOff held = held_off(drapes);
    add("triangles held off the skin", "%", held.triangles, -HUGE_VAL, 0);
    add("largest distance at which contact lets the cloth's middle surface rest", "mm",
        held.distance, -HUGE_VAL, 1e3 * half_thickness * (1 + kRoundOff));
    const HemHeights hem = hem_heights(drapes);
    const auto [low, high] = std::minmax_element(hem.begin(), hem.end());
    add("highest of right, front, back and left of the hem over the lowest", "mm",
        1e3 * (*high - *low), 0, kHemRange, wearer.hem_missed, kBackHangs);
    result.notes.push_back(fmt::format(
        "{}: the hem stands {:.0f} mm over its lowest place at the right, {:.0f} in front, {:.0f} "
        "behind, {:.0f} at the left; {:.1f} weights more are squeezed between arms and trunk.",
        wearer.who, 1e3 * (hem[hem_right] - *low), 1e3 * (hem[hem_front] - *low),
        1e3 * (hem[hem_back] - *low), 1e3 * (hem[hem_left] - *low),
        load->between_arm_and_trunk / load->weight));
  }
  result.notes.push_back(
      fmt::format("Worn in; hems are means of {0} donnings, what is held off is the most of {0}, "
                  "all else of the first. Contact: on a lattice over the flat triangles. Cloth "
                  "that is not held off rests at half its thickness.",
                  kDonnings));
  return result;
}

}  // namespace loosefit::validate
