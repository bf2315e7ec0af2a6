#include "loosefit/pipeline/case_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/body/scan_body.h"
#include "loosefit/body/scan_frame.h"
#include "loosefit/body/scan_person.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/io/mesh_file.h"
#include "loosefit/pipeline/no_room_advice.h"

namespace loosefit::pipeline {
namespace {

constexpr char kOtherPosture[] =
    "another body.dress_posture may do: most room is where the arms are 55 degrees apart from the "
    "trunk (arm_abduction_deg = 55)";
constexpr char kOtherScan[] =
    "body.posture = \"standing\" puts it on with the arms apart, where the body model can be laid "
    "on "
    "the scan; or scan the person with the arms farther from the trunk";

const body::BodyModel& shared_model() {
  static const body::BodyModel kModel = body::BodyModel::load();
  return kModel;
}

body::BodySpec spec_of(const scenario::ScenarioBody& wished) {
  return {.sex = wished.sex,
          .age = wished.age,
          .height = wished.height,
          .measurements = wished.measurements,
          .muscle = wished.muscle,
          .proportions = wished.proportions,
          .cup = wished.cup,
          .firmness = wished.firmness};
}

body::BodyPath way(const std::shared_ptr<flesh::SoftBody>& person, const body::Posture& from,
                   const body::Posture& to) {
  return [person, from, to](double share) { return person->in(body::blend(from, to, share)); };
}

/// Makes everything of the body ask this person.
void ask_of(CaseBody& body, std::shared_ptr<flesh::SoftBody> person, bool offer_wide) {
  body.person = std::move(person);
  body.path = way(body.person, body.from, body.to);
  body.wide_path = offer_wide ? way(body.person, body.wide, body.to) : body::BodyPath{};
}

/// The person as scanned: put on in that posture, without movements of the arms.
CaseBody as_scanned(body::Body body, std::vector<std::string> warnings) {
  CaseBody result;
  result.warnings = std::move(warnings);
  result.body = std::move(body);
  result.path = [posed = result.body](double) { return posed; };
  return result;
}

CaseBody posed_person(const body::BodyParameters& parameters, const body::Posture& posture,
                      const body::Posture& dress_posture, Progress* progress) {
  CaseBody result;
  result.from = dress_posture, result.to = posture;
  result.parameters = parameters;
  ask_of(result, std::make_shared<flesh::SoftBody>(shared_model(), parameters),
         dress_posture == body::default_dress_posture(posture) &&
             dress_posture.arm_abduction < body::kArmsWide.arm_abduction);
  if (progress) progress->check_cancelled();
  result.body = result.person->in(body::blend(result.from, result.to, 1), progress);  // path(1)
  return result;
}

/// The model on the scan, or nothing where it cannot be laid on, or is not there.
std::optional<body::ScanPerson> registered(const geometry::TriangleMesh& mesh,
                                           const body::ScanOptions& options) try {
  return body::person_from_scan(shared_model(), mesh, options);
} catch (const IoError&) {  // no body data
  return std::nullopt;
}

std::string lean_in_words(double bend) {
  if (bend == 0) return "upright";
  return fmt::format("leaning {} by {:.0f} degrees", bend > 0 ? "forward" : "back",
                     degrees(std::abs(bend)));
}

/// The unit that a file states, if a person of it can stand there; empty otherwise.
std::string unit_of_file(const io::MeshFile& file, std::vector<std::string>& warnings) {
  const std::optional<double> metre = body::metres_of(file.units);
  if (!metre) return {};
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& p : file.mesh.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double stature = (high - low).maxCoeff() * *metre;
  const bool stands = stature >= body::kShortestPerson && stature <= body::kTallestPerson;
  warnings.push_back(fmt::format(
      "units: the file says {}, in which it is {:.3g} m tall{}", file.units, stature,
      stands ? "; taken so (body.units or --units says otherwise)" : ", as nobody is: not taken"));
  return stands ? file.units : std::string();
}

CaseBody body_from_file(const scenario::ScenarioBody& wished, Progress* progress) {
  io::MeshFile file = io::read_mesh(wished.file);
  std::vector<std::string> warnings = std::move(file.warnings);
  body::ScanOptions options{.file = wished.file, .units = wished.units, .up = wished.up};
  if (options.units.empty()) options.units = unit_of_file(file, warnings);
  std::optional<body::ScanPerson> person = registered(file.mesh, options);
  const auto add = [&](const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  };
  if (!person) {
    // The surface itself, which keeps its posture; or what is wrong with it.
    body::ScanBody scan = body::body_from_scan(std::move(file.mesh), options);
    if (!wished.as_scanned)
      throw GeometryError({wished.file, 0, ""}, "a surface on which the body model cannot be laid",
                          "one standing person, scanned in tight clothes",
                          "without body.posture and [postures] it is dressed as scanned");
    add(scan.warnings);
    warnings.push_back(
        "the body model cannot be laid on this surface, which is dressed as it is: clothes, if it "
        "wears any, are taken for skin");
    return as_scanned(std::move(scan.body), std::move(warnings));
  }
  add(person->warnings);
  const double aside = person->posture.arm_abduction;
  const bool open = aside >= body::kLeastOpen && aside <= body::kMostOpen;
  CaseBody result;
  const bool folded = !flesh::overlaps_of(person->body).empty();
  if (wished.as_scanned && open && !folded) {
    result = as_scanned(std::move(person->body), std::move(warnings));
    result.parameters = std::move(person->parameters);
    return result;
  }
  const body::RigidMotion from_world = person->body.from_world;
  if (wished.as_scanned) {
    warnings.push_back(fmt::format(
        "{}: the person is posed by a fitted skeleton and ends {}, legs as people stand, with both "
        "arms {:.0f} degrees from the trunk; body.posture asks for another posture",
        open
            ? "skin of the scan meets skin, and flesh has to give way there"
            : fmt::format("the arms of the scan are {:.0f} degrees from the trunk, where a garment "
                          "cannot be put on",
                          degrees(aside)),
        lean_in_words(person->posture.forward_bend), degrees(aside)));
    result = posed_person(person->parameters, person->posture,
                          body::default_dress_posture(person->posture), progress);
  } else {
    result = posed_person(person->parameters, wished.posture, wished.dress_posture, progress);
  }
  // A pattern file placed round the scan goes with the person.
  body::Body placed = result.body;
  placed.from_world = from_world;
  result.body = std::move(placed);
  result.warnings = std::move(warnings);
  return result;
}

}  // namespace

CaseBody make_body(const scenario::ScenarioBody& wished, Progress* progress) {
  if (!wished.file.empty()) return body_from_file(wished, progress);
  const body::BodyFit fit =
      body::fit_body(shared_model(), spec_of(wished), body::BodyDetail::subdivided, progress);
  CaseBody result = posed_person(fit.parameters, wished.posture, wished.dress_posture, progress);
  result.asked = fit.table;
  result.warnings = fit.warnings;
  return result;
}

CaseBody clone_wearer(const CaseBody& body) {
  CaseBody copy = body;
  if (body.person)
    ask_of(copy, std::make_shared<flesh::SoftBody>(*body.person), bool(body.wide_path));
  return copy;
}

void widen(CaseBody& body, double arm_abduction) {
  if (!body.person || !body.wide_path) return;
  body.wide.arm_abduction = std::clamp(arm_abduction, body::kArmsWide.arm_abduction, radians(90.0));
  ask_of(body, body.person, true);
}

std::vector<std::string> warnings_since(const CaseBody& before, const CaseBody& after) {
  const std::vector<std::string>& all = after.dressing_warnings;
  return {all.begin() + static_cast<long>(before.dressing_warnings.size()), all.end()};
}

drape::Drape put_on(drape::DrapeSession& session, CaseBody& body,
                    const std::vector<CaseMovement>& movements,
                    const scenario::Scenario* scenario) try {
  drape::Movements made = movements_of(body.body, body.person, body.to, movements);
  body.movements.clear();
  for (const CaseMovement& wanted : movements)
    if (std::ranges::find(made, wanted.name, &drape::Movement::name) != made.end())
      body.movements.push_back(wanted);
  drape::Drape drape = session.put_on(body.path, body.wide_path, std::move(made));
  if (!drape.report.no_room.empty()) {
    body.path = std::exchange(body.wide_path, {});
    body.from = body.wide;
    body.dressing_warnings.push_back(
        "put on with the arms wide apart, since in the usual posture " + drape.report.no_room);
  }
  return drape;
} catch (const dress::NoRoom& error) {
  const std::string less_garment = scenario ? no_room_advice(*scenario) : "a smaller garment";
  if (body.wide_path)
    throw GeometryError(std::string(error.what()) + ", even with the arms wide apart",
                        less_garment);
  const bool can_spread = body.person && body.from.arm_abduction < body::kArmsWide.arm_abduction;
  if (!can_spread && body.person) throw GeometryError(error.what(), less_garment);
  throw GeometryError(error.what(), can_spread ? kOtherPosture : kOtherScan);
}

}  // namespace loosefit::pipeline
