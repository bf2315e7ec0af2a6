#include "loosefit/pipeline/case_body.h"

#include <algorithm>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/body/scan_body.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/io/mesh_file.h"

namespace loosefit::pipeline {
namespace {

constexpr char kOtherPosture[] =
    "another body.dress_posture may do: most room is where the arms are 55 degrees apart from the "
    "trunk (arm_abduction_deg = 55)";
constexpr char kOtherScan[] = "scan the person with the arms farther from the trunk";

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
  body.wide_path = offer_wide ? way(body.person, body::kArmsWide, body.to) : body::BodyPath{};
}

// A scan stands as it stands: the garment is put on in that posture.
CaseBody body_from_file(const scenario::ScenarioBody& wished) {
  io::MeshFile file = io::read_mesh(wished.file);
  body::ScanBody scan = body::body_from_scan(
      std::move(file.mesh), {.file = wished.file, .units = wished.units, .up = wished.up});
  CaseBody result;
  result.warnings = std::move(file.warnings);
  result.warnings.insert(result.warnings.end(), scan.warnings.begin(), scan.warnings.end());
  result.body = std::move(scan.body);
  result.path = [body = result.body](double) { return body; };
  return result;
}

}  // namespace

CaseBody make_body(const scenario::ScenarioBody& wished, Progress* progress) {
  if (!wished.file.empty()) return body_from_file(wished);
  const body::BodyModel& model = shared_model();
  const body::BodyFit fit = body::fit_body(model, spec_of(wished));
  CaseBody result;
  result.from = wished.dress_posture, result.to = wished.posture;
  ask_of(result, std::make_shared<flesh::SoftBody>(model, fit.parameters),
         wished.dress_posture == body::default_dress_posture(wished.posture) &&
             wished.dress_posture.arm_abduction < body::kArmsWide.arm_abduction);
  if (progress) progress->check_cancelled();
  result.body = result.person->in(body::blend(result.from, result.to, 1), progress);  // path(1)
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

std::vector<std::string> warnings_since(const CaseBody& before, const CaseBody& after) {
  return {after.warnings.begin() + static_cast<long>(before.warnings.size()), after.warnings.end()};
}

drape::Drape put_on(drape::DrapeSession& session, CaseBody& body,
                    const std::vector<CaseMovement>& movements) try {
  drape::Movements made = movements_of(body.body, body.person, body.to, movements);
  body.movements.clear();
  for (const CaseMovement& wanted : movements)
    if (std::ranges::find(made, wanted.name, &drape::Movement::name) != made.end())
      body.movements.push_back(wanted);
  drape::Drape drape = session.put_on(body.path, body.wide_path, std::move(made));
  if (!drape.report.no_room.empty()) {
    body.path = std::exchange(body.wide_path, {});
    body.from = body::kArmsWide;
    body.warnings.push_back("put on with the arms wide apart, since in the usual posture " +
                            drape.report.no_room);
  }
  return drape;
} catch (const dress::NoRoom& error) {
  if (!body.wide_path) throw GeometryError(error.what(), body.person ? kOtherPosture : kOtherScan);
  throw GeometryError(std::string(error.what()) + ", even with the arms wide apart",
                      "a garment so wide finds no room between arms and trunk: a smaller "
                      "garment.fit, or a smaller size, can be put on");
}

}  // namespace loosefit::pipeline
