#pragma once
#include <memory>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_model.h"
#include "loosefit/body/posed_body.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/pipeline/wearer_movements.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::flesh {
class SoftBody;
}

namespace loosefit::pipeline {

/// Stage "body": the wearer in the wanted posture, and the way there from the dressing posture.
/// Copies ask the same person, one caller at a time; see clone_wearer.
struct CaseBody {
  body::PosedBody body;  ///< in the wanted posture
  body::BodyPath path;   ///< share 0 dressing posture … 1 `body`
  /// The way from arms wide apart, for garments that cannot be laid in the usual dressing posture;
  /// empty when another one was chosen, when the arms are as wide already, and for a scan.
  body::BodyPath wide_path;
  body::Posture wide = body::kArmsWide;     ///< where the wide path begins
  body::Posture from, to;                   ///< of the path, unless as scanned
  std::shared_ptr<flesh::SoftBody> person;  ///< whom all of these ask; null as scanned
  body::BodyParameters parameters;      ///< of the model; of a surface that it is not laid on: none
  std::vector<CaseMovement> movements;  ///< that were made once the garments were on
  std::vector<body::MeasureRow> asked;  ///< wishes against what the surface measures [m]
  std::vector<std::string> warnings;    ///< from the fit or the scan's check
  std::vector<std::string> dressing_warnings;  ///< of putting on
};

/// The parametric person, or the one of a file: the body model laid on the scan where it can be
/// (scan_person.h), the surface itself otherwise. As scanned, where nobody asks for a posture and
/// the arms are apart as far as a garment needs; then there is no person to ask.
/// The baked body data are loaded once per process. `progress` is asked whether to go on, and hears
/// of the way of flesh to the posture.
/// \throws InvalidInput for impossible wishes or a broken scan; IoError without body data;
/// Cancelled.
CaseBody make_body(const scenario::ScenarioBody& wished, Progress* progress = nullptr);

/// The same wearer for somebody who asks at the same time as others: what it answers depends on
/// nothing that they ask.
CaseBody clone_wearer(const CaseBody& body);

/// Lets the wide path begin with the upper arms so far aside [rad], but no nearer than kArmsWide
/// and no higher than level, as sleeves cut in one with the trunk are drawn.
void widen(CaseBody& body, double arm_abduction);

/// Of what putting on `after`, who began as a copy of `before`, has warned since.
std::vector<std::string> warnings_since(const CaseBody& before, const CaseBody& after);

/// Puts the garment on along the body's path or, where it cannot be laid in the usual dressing
/// posture, along its wide one, which then is its path, with a warning. Of the movements those that
/// this wearer can make are made and kept in the body; without any the garment is not worn in.
/// `scenario`: for what can be advised.
/// \throws GeometryError when it cannot be laid at all.
drape::Drape put_on(drape::DrapeSession& session, CaseBody& body,
                    const std::vector<CaseMovement>& movements,
                    const scenario::Scenario* scenario = nullptr);

}  // namespace loosefit::pipeline
