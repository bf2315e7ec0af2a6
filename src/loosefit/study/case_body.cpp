#include "loosefit/study/case_body.h"

namespace loosefit {
namespace {

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

}  // namespace

CaseBody make_body(const ScenarioBody& wished) {
  const BodyModel& model = shared_model();
  const BodyFit fit = model.fit(spec_of(wished));
  CaseBody result;
  result.path = [&model, parameters = fit.parameters, from = wished.dress_posture,
                 to = wished.posture](double share) {
    return model.build(parameters, blend(from, to, share));
  };
  result.body = result.path(1);
  result.asked = fit.table;
  result.warnings = fit.warnings;
  return result;
}

}  // namespace loosefit
