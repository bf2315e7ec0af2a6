#pragma once
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "loosefit/base/stage_clock.h"
#include "loosefit/lines/find_routes.h"
#include "loosefit/lines/line_metrics.h"
#include "loosefit/lines/sensitivity.h"
#include "loosefit/pipeline/answer.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/case_garment.h"
#include "loosefit/pipeline/case_state.h"
#include "loosefit/placement/scorecard.h"
#include "loosefit/placement/sites.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// How the garments were put on for one donning.
struct CaseDonning {
  Vec3 shift = Vec3::Zero();                 ///< [m]
  double twist = 0;                          ///< [rad]
  double friction = 1;                       ///< share of the materials' coefficients
  std::vector<CaseMovement> movements = {};  ///< once they were on
};

/// A case worn in several postures, after several donnings. Empty for one of each.
struct CaseWear {
  std::vector<std::string> postures;  ///< the first is the reference posture
  std::vector<CaseDonning> donnings;  ///< planned_donnings
  /// Per posture; none for the reference posture (CaseResult::body), nor without states.
  std::vector<body::PosedBody> bodies;
  std::vector<CaseState> states;      ///< all but the reference state
  std::vector<std::string> warnings;  ///< of putting on again
};

/// Spread of one number over the repeats of a case.
struct Spread {
  double mean = 0, deviation = 0;  ///< sample standard deviation
  int count = 0;
};

/// Stage "repeats": drapes from other starts.
struct CaseRepeats {
  /// Key of summary.json ("maps.distance_mm.area_mean") → spread over all drapes that settled, of
  /// what each of them has.
  std::map<std::string, Spread> spread;
  std::vector<std::string> warnings;
};

/// Whether somebody gets into the garments as they are cut.
struct PuttingOn {
  std::optional<bool> possible;      ///< false: a fastening is needed; absent: not judged
  std::vector<std::string> reasons;  ///< why not, and what was not judged (drape/putting_on.h)
};

/// Stage "maps".
struct MapStage {
  std::vector<CaseMaps> garments;  ///< as CaseResult::garments
  std::vector<StateMaps> states;   ///< as CaseWear::states; empty for those that do not count
};

/// Stage "placement".
struct SiteStage {
  std::vector<placement::Site> sites;  ///< on the studied garment, in the reference state
  std::vector<placement::UncoveredSite> uncovered;  ///< those that it does not cover
  /// The same sensors in other states, as CaseWear::states; empty for those that do not count.
  std::vector<std::vector<placement::Site>> in_states;
};

/// A sensor that is a line, and what it sees.
struct CaseLine {
  std::string name;
  lines::LineCourse course;
  lines::LineSensor sensor;
  std::vector<lines::LineState> states;  ///< the reference state first, then others that count
  std::vector<double> signals;           ///< per state (lines/line_metrics.h)
  std::vector<std::map<std::string, double>> metrics;  ///< per donning
  std::vector<lines::Sensitivity> sensitivities;       ///< of joints that the postures sweep
  /// By each of its scorecards, in their order: of the donning in which it does worst.
  struct Verdict {
    std::string scorecard, title;
    placement::Score score;
    double pass = 0.5;
    bool passes() const { return score.q && *score.q >= pass; }
  };
  std::vector<Verdict> verdicts = {};
  /// Of a course of least strain: the routes, best first, the course being the first; and the
  /// shortest way, which is not taken.
  std::vector<lines::Route> routes = {};
  std::optional<lines::Route> shortest = {};
};

/// Stage "placement" of lines.
struct LineStage {
  std::vector<CaseLine> lines;
  std::vector<placement::UncoveredSite> left_out;  ///< what could not be laid, with the reason
};

/// Everything one case yields, stage by stage. A drape that is not settled or not worn is sealed:
/// maps and `sites` stay empty unless they were asked for all the same.
struct CaseResult {
  scenario::Scenario scenario;
  CaseBody body;
  std::vector<CaseGarment> garments{1};  ///< the innermost first; the last one is studied
  PuttingOn putting_on;
  CaseWear wear;
  std::vector<placement::Site> sites;  ///< on the studied garment
  std::vector<placement::UncoveredSite> uncovered_sites;
  std::vector<CaseLine> lines;  ///< of the sites that are lines
  std::vector<placement::UncoveredSite> lines_left_out;
  std::vector<Answer> answers;  ///< what to sew where and what to expect (answers.h)
  CaseRepeats repeats;
  std::vector<StageClock::Entry> seconds;  ///< per stage, in order
  double peak_memory_mb = 0;
  std::vector<std::string> warnings;

  CaseGarment& studied() { return garments.back(); }
  const CaseGarment& studied() const { return garments.back(); }
  /// The garments under the studied one, the innermost first.
  std::span<const CaseGarment> worn_under() const {
    return std::span(garments).first(garments.size() - 1);
  }
  /// Of all garments together, in the reference state.
  const drape::Certificate& certificate() const { return studied().drape.certificate; }
  bool sealed() const { return !certificate().holds() && studied().maps.maps.empty(); }
  /// The wearer in a posture of `wear`.
  const body::PosedBody& body_in(int posture) const {
    return posture == StateId::kReferencePosture ? body.body : wear.bodies[posture];
  }
  /// What the stages have made, each in its place. \throws Error unless there are as many as
  /// garments and states.
  void take_drapes(std::vector<drape::Drape> drapes);
  void take_maps(MapStage made);
  void take_sites(SiteStage made);
  void take_lines(LineStage made);
};

}  // namespace loosefit::pipeline
