#include "loosefit/study/case_body.h"

#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/body/scan_body.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/io/mesh_file.h"

namespace loosefit {
namespace {

constexpr char kOtherPosture[] =
    "another body.dress_posture may do: most room is where the arms are 55 degrees apart from the "
    "trunk (arm_abduction_deg = 55)";
constexpr char kOtherScan[] = "scan the person with the arms farther from the trunk";

const BodyModel& shared_model() {
  static const BodyModel kModel = BodyModel::load();
  return kModel;
}

BodySpec spec_of(const ScenarioBody& wished) {
  return {.sex = wished.sex,
          .age = wished.age,
          .height = wished.height,
          .measurements = wished.measurements,
          .muscle = wished.muscle,
          .proportions = wished.proportions,
          .cup = wished.cup,
          .firmness = wished.firmness};
}

BodyPath way(const std::shared_ptr<SoftBody>& person, const Posture& from, const Posture& to) {
  return [person, from, to](double share) { return person->in(blend(from, to, share)); };
}

/// Everything that asks the person.
void let_ask(CaseBody& body, std::shared_ptr<SoftBody> person, bool offer_wide) {
  body.person = std::move(person);
  body.path = way(body.person, body.from, body.to);
  body.wide_path = offer_wide ? way(body.person, kArmsWide, body.to) : BodyPath{};
}

// A scan stands as it stands: the garment is put on in that posture.
CaseBody body_from_file(const ScenarioBody& wished) {
  MeshFile file = read_mesh(wished.file);
  ScanBody scan = body_from_scan(std::move(file.mesh),
                                 {.file = wished.file, .units = wished.units, .up = wished.up});
  CaseBody result;
  result.warnings = std::move(file.warnings);
  result.warnings.insert(result.warnings.end(), scan.warnings.begin(), scan.warnings.end());
  result.body = std::move(scan.body);
  result.path = [body = result.body](double) { return body; };
  return result;
}

}  // namespace

CaseBody make_body(const ScenarioBody& wished) {
  if (!wished.file.empty()) return body_from_file(wished);
  const BodyModel& model = shared_model();
  const BodyFit fit = fit_body(model, spec_of(wished));
  CaseBody result;
  result.from = wished.dress_posture, result.to = wished.posture;
  let_ask(result, std::make_shared<SoftBody>(model, fit.parameters),
          wished.dress_posture == default_dress_posture(wished.posture) &&
              wished.dress_posture.arm_abduction < kArmsWide.arm_abduction);
  result.body = result.path(1);
  result.asked = fit.table;
  result.warnings = fit.warnings;
  return result;
}

CaseBody another_caller(const CaseBody& body) {
  CaseBody copy = body;
  if (body.person) let_ask(copy, std::make_shared<SoftBody>(*body.person), bool(body.wide_path));
  return copy;
}

std::vector<std::string> warnings_since(const CaseBody& before, const CaseBody& after) {
  return {after.warnings.begin() + static_cast<long>(before.warnings.size()), after.warnings.end()};
}

Drape put_on(DrapeSession& session, CaseBody& body) try {
  Drape drape = session.put_on(body.path, body.wide_path);
  if (!drape.report.no_room.empty()) {
    body.path = std::exchange(body.wide_path, {});
    body.from = kArmsWide;
    body.warnings.push_back("put on with the arms wide apart, since in the usual posture " +
                            drape.report.no_room);
  }
  return drape;
} catch (const NoRoom& error) {
  if (!body.wide_path) throw GeometryError(error.what(), body.person ? kOtherPosture : kOtherScan);
  throw GeometryError(std::string(error.what()) + ", even with the arms wide apart",
                      "a garment so wide finds no room between arms and trunk: a smaller "
                      "garment.fit, or a smaller size, can be put on");
}

}  // namespace loosefit
