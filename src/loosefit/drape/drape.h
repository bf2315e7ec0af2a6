#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/drape/recovery.h"
#include "loosefit/drape/stop_reason.h"
#include "loosefit/drape/unsettled.h"
#include "loosefit/solver/rest_tolerance.h"
#include "loosefit/solver/solver_work.h"

namespace loosefit::drape {

/// Proof that a drape is at rest and worn, or why it is not (docs/theory/solver.md 1).
struct Certificate {
  double residual = 1;  ///< ‖F‖₂ / ‖W‖₂ over free particles, W of the cloth alone [–]
  double residual_max = 1;  ///< max ‖F_i‖ / mean ‖W_i‖ [–]
  /// Triangle pairs, exact test, and triangles that reach below the floor; -1 = not tested.
  int intersections_body = -1;
  int intersections_self = -1;   ///< the same, and folded edges
  std::string stop_reason;       ///< "converged", "time budget", "iteration limit", …
  int intersections_layers = 0;  ///< of intersections_self, those between two garments
  int folded_edges = 0;          ///< of intersections_self, edges on which cloth is folded flat
  /// Whether the exact Hessian is positive definite (solver/stability.h): the balance is a minimum
  /// of the energy and no saddle; absent: not tested.
  std::optional<bool> stable = {};
  /// Why it is not worn (drape/worn.h); of a drape of several garments those of each. Who only
  /// drapes does not ask: empty then.
  std::vector<std::string> worn_reasons = {};
  /// What the residual is judged by [–]: kRestTolerance, or the tolerance that was sought where
  /// that was looser (DrapeOptions::residual_tolerance).
  double allowed_residual = solver::kRestTolerance;
  StopReason reason = StopReason::unknown;  ///< stop_reason in one word
  bool worn() const { return worn_reasons.empty(); }
  /// What maps and exit codes ask for.
  bool holds() const { return settled() && worn(); }
  /// As residual, of residual_max.
  double allowed_largest() const {
    return solver::kRestLargest * (allowed_residual / solver::kRestTolerance);
  }
  bool is_balanced() const {
    return residual <= allowed_residual && residual_max <= allowed_largest();
  }
  bool settled() const {
    return is_balanced() && intersections_body == 0 && intersections_self == 0;
  }
};

/// One sample of the residual history of a settle run.
struct SettleSample {
  double seconds = 0;
  int level = 0;
  int iteration = 0;
  double residual = 0;
};

/// What one part of a run took on one level.
struct PartWork {
  std::string part;  ///< "dress", "posture", "settle"
  int level = 0, vertices = 0;
  int start = 0;  ///< putting on that it belongs to: 0 first, 1 second
  solver::SolverWork work;
};

/// How often a recovery was tried (drape/recoveries.h).
struct RecoveryCount {
  RecoveryKind kind;
  std::string name;
  int times = 0;
};

/// Counters and timers of a settle run.
struct SettleReport {
  int ccd_queries = 0;
  std::vector<PartWork> parts;  ///< in the order of the run
  int contacts_body = 0, contacts_self = 0;
  double floor_force = 0;  ///< Σ of the normal forces of the floor on the cloth [N]
  /// Triangles that cut the skin and are held off beyond half the fabric thickness, and the largest
  /// rest distance from the skin that any contact point has for it [m].
  int held_off_triangles = 0;
  double largest_contact_offset = 0;
  /// Area of the cloth for which the contact points stand that bear a force [m²], and the distance
  /// of the middle surface from what contact sees (skin, or what fills a cleft) within which 97 %
  /// of it lies [m]; absent where nothing bears.
  double bearing_area = 0;
  std::optional<double> bearing_distance;
  std::vector<SettleSample> history;
  /// Spacing of the field of distances where it had to be coarser than asked for [m]; else 0.
  double coarsened_field = 0;
  std::vector<RecoveryCount> recoveries;  ///< in the order of their first trial
  /// Why the garment found no room in the first dressing posture; empty: it did.
  std::string no_room;

  /// One more trial.
  void count(RecoveryKind kind, const std::string& name);
  bool was_tried(RecoveryKind kind) const;
  solver::SolverWork total() const {
    solver::SolverWork sum;
    for (const PartWork& p : parts) sum += p.work;
    return sum;
  }
};

/// A garment on a body: positions with their certificate. Maps refuse an unsettled one.
struct Drape {
  std::vector<Vec3> positions;           ///< per garment vertex [m]
  std::vector<Vec3> body_contact_force;  ///< normal + friction force of the body on each vertex [N]
  /// Magnitude of the normal force of the body alone, shared among the vertices so that the sum is
  /// the total normal force [N]; empty where it is not known.
  std::vector<double> body_normal_force;
  Certificate certificate;
  SettleReport report;
  std::optional<Unsettled> unsettled;  ///< why it is not settled, when it is not
};

}  // namespace loosefit::drape
