#pragma once
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_path.h"
#include "loosefit/drape/cloth_layer.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/drape.h"
#include "loosefit/drape/drape_options.h"
#include "loosefit/drape/free_fall.h"
#include "loosefit/drape/movement.h"
#include "loosefit/drape/recovery.h"
#include "loosefit/drape/settling_budget.h"
#include "loosefit/drape/stop_reason.h"
#include "loosefit/solver/integrator.h"

namespace loosefit::drape {

/// How putting on left the cloth; other postures are reached from there.
struct WornCloth {
  /// A coarser level when it was handed on, the finest at rest.
  struct Level {
    std::vector<Vec3> x;
    ClothMemory memory;
  };
  std::vector<Level> levels;
  std::shared_ptr<const ContactBody> body;
  int iterations = 0;  ///< that the finest level took
};

/// Where one call of ClothState::settle is to end.
struct SettleGoal {
  double tolerance;    ///< residual ‖F‖/‖W‖ [–]
  int max_iterations;  ///< of this call; the drape's own limit holds besides
  double first_dt;     ///< first pseudo-step [s]
  /// On the way to a posture: always quasi-static, and no state of it is kept.
  bool preparing = false;
};
inline constexpr int kNoLimit = std::numeric_limits<int>::max();

/// The step of the body that is planned or has just been made (phases/follow_posture.h), in shares
/// of the path.
struct PostureStep {
  double done = 0;       ///< the body stands here
  double length = 0;     ///< of the step
  double least = 0;      ///< length below which it is not halved
  bool blocked = false;  ///< the cloth cannot go along all of it
};

/// One drape on its way: a garment, or several worn over each other, the body under it, and what
/// all phases (drape/phases) share and change. The phases are functions of it; drape/settle_garment
/// calls them in order.
struct ClothState {
  /// Keeps references to all arguments. `recoveries`: drape/recoveries.h. \throws InvalidInput for
  /// no layers, layers of different edge lengths, or a tuning out of bounds.
  ClothState(const std::vector<ClothLayer>& layers, const DrapeOptions& options,
             const Recoveries& recoveries, Progress& progress);
  ClothState(const ClothState&) = delete;
  ClothState& operator=(const ClothState&) = delete;

  // What is asked.
  const std::vector<ClothLayer>& layers;
  const DrapeOptions& options;
  const SettlingTuning& tuning;
  const Recoveries& recoveries;
  Progress& progress;

  // Where the drape is.
  SettlingBudget budget;
  int level = 0;               ///< 0 is the coarsest
  std::string part = "dress";  ///< for the report
  std::vector<Vec3> x;         ///< of all layers in turn [m]
  std::shared_ptr<const ContactBody> body;
  /// Bodies whose field the cloth has left: states that are kept may still ask it.
  std::vector<std::shared_ptr<const ContactBody>> outgrown;
  std::unique_ptr<ClothModel> model;  ///< the energies of this level
  solver::SettleOutcome last;         ///< of the last `settle`
  std::optional<Stop> falling;        ///< cloth that nothing holds: all further work is vain
  std::optional<Stop> given_up;       ///< a posture that is not followed further
  std::optional<Stop> stalled;        ///< the last settling made no progress; a new one begins anew
  std::optional<Stop> went_back;   ///< how the kept state had ended that `x` is; settling ends it
  std::string no_room;             ///< why the garment cannot be laid round the body; or empty
  body::BodyPath path, wide_path;  ///< of the body; the second for more room, may be empty
  bool arms_go_up = false;         ///< in the posture in which it is put on
  Movements movements;             ///< of the wearer, once the garment is on
  double friction_share = 1;       ///< that the wearer's fidgeting leaves (phases/wear_in.h) [–]
  PostureStep step;
  Certificate certificate;
  SettleReport report;

  /// A state of the finest level on the last body, to come back to.
  struct Kept {
    std::vector<Vec3> x;
    ClothMemory memory;
    double residual = 0;
    int held_off_triangles = 0;
    std::shared_ptr<const ContactBody> body;  ///< that the memory asks for distances
    int start = 0;                            ///< as ClothState::start
    std::map<int, int> times_cut = {};        ///< as ClothState::times_cut
    std::optional<Stop> stop = {};            ///< absent: as the drape ends
  };
  std::optional<Kept> lowest;     ///< that of the lowest residual, penetrations or not
  std::optional<Kept> clear;      ///< that of the lowest residual among those found free of them
  std::optional<Kept> first_try;  ///< the best before the cloth was put on anew
  std::optional<Kept> saddle;     ///< the first settled one that was left as a saddle
  bool best_was_taken = false;    ///< `x` is the best of them
  std::set<int> penetrating;      ///< triangles that cut the skin when last looked
  std::map<int, int> times_cut;   ///< rounds in which each triangle's offsets were raised
  std::shared_ptr<const WornCloth> worn;  ///< following: where it starts
  /// Per start, that is each time that the garments were put on: the levels so far.
  std::vector<std::vector<WornCloth::Level>> handed_on{1};
  int start = 0;                         ///< that `x` comes from
  std::map<RecoveryKind, int> attempts;  ///< of each, as often as it was tried

  int layer_count() const { return static_cast<int>(layers.size()); }
  int level_count() const { return static_cast<int>(layers.front().garment->levels.size()); }
  bool is_finest() const { return level + 1 == level_count(); }
  bool is_single() const { return layers.size() == 1; }
  /// Whether it is worn cloth that nothing has moved yet.
  bool is_as_worn() const { return worn && body == worn->body; }
  const garment::Garment& garment(int layer) const { return layers[layer].garment->levels[level]; }
  std::vector<const garment::Garment*> garments() const;
  const std::vector<Triangle>& triangles() const { return model->mesh().triangles; }

  /// No time or iterations are left, or what falls freely has made all further work vain.
  bool must_stop() const;
  /// That, or the phase has had its iterations or makes no progress.
  bool is_over() const { return must_stop() || stalled || budget.phase_is_over(); }
  /// How what `x` is ended: the last settling, unless something else cut it short.
  Stop how_it_ended() const;

  /// Energies of this level; `stiffness_share` of the membrane's stiffness.
  void make_model(double stiffness_share = 1, bool with_friction = true);
  /// Lays a soft layer between body and cloth (ClothModel::soften_body_contact), or takes it away.
  /// Several layers get none: it frees cloth from the skin, not from other cloth.
  void soften_contact(bool soft);
  /// Friction holds `friction_share` until `stick`, which lets it hold in full from where the cloth
  /// lies: what was locked in by friction on the way there is gone, but for that share.
  void loosen_friction();
  void stick();
  /// Moves the cloth by as much of `displacement` as nothing meets on the way [m].
  void move_without_collision(const std::vector<Vec3>& displacement);
  /// Moves the anchors of friction along with the skin under them [m].
  void carry_anchors(const std::vector<Vec3>& displacement);
  /// Settles this level; the outcome is `last`.
  void settle(const SettleGoal& goal);
  void keep(std::optional<Kept>& kept, double residual) const;
  /// Goes through the recoveries of this point in their order. The first one whose failure has
  /// occurred, and which may be tried once more, is carried out, told and counted; whether there
  /// was one.
  bool recover(RecoveryPoint point);

 private:
  /// Whether the lowest residual has not fallen for too long (StallTuning).
  bool is_stalled(int iteration, double residual);

  double fraction_ = 0;                             ///< that progress was told last
  double progress_to_ = 0;                          ///< the residual at its last fall
  int progress_at_ = 0;                             ///< iteration of that
  double progress_height_ = 0;                      ///< of the middle of the cloth then [m]
  std::optional<FreeFall> free_fall_;               ///< of the garments of this level
  std::unique_ptr<solver::Integrator> integrator_;  ///< of `model`
  IntegratorKind integrator_kind_ = IntegratorKind::quasi_static;
};

}  // namespace loosefit::drape
