#pragma once
#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_path.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/drape.h"
#include "loosefit/drape/drape_options.h"
#include "loosefit/drape/free_fall.h"
#include "loosefit/solver/integrator.h"

namespace loosefit {

/// Residual at which a level is handed to the finer one.
inline constexpr double kCoarseTolerance = 1.0;
/// Thickness of the soft layer between body and cloth until it stands in its posture [m]: contacts
/// then come one after another over millimetres of way and not all within the last tenth of one, so
/// Newton's steps stay whole, and nothing is pulled through the skin.
inline constexpr double kPad = 0.005;
/// First pseudo-step near rest [s].
inline constexpr double kStaticDt = 10;

/// What progress is told when a drape that failed is tried again.
inline constexpr char kOnceMore[] = "not at rest; trying once more from farther off the skin";

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

/// A garment, or several worn over each other, on the way to rest, and on to other postures: knows
/// the state of the cloth, the body under it, the clock, the report and whom to tell. Keeps
/// references to all arguments of the constructor.
class ClothRun {
 public:
  /// \throws InvalidInput for no layers, or layers of different edge lengths.
  ClothRun(const std::vector<ClothLayer>& layers, const DrapeOptions& options, Progress& progress);
  /// Another one of the same garments, as `start` has been left by put_on.
  ClothRun(const std::vector<ClothLayer>& layers, const DrapeOptions& options,
           std::shared_ptr<const WornCloth> start, Progress& progress);

  /// Dress and settle, as drape_garment.
  Drape put_on(const BodyPath& body_at);
  /// As DrapeSession::follow. \pre there is a `worn`
  Drape follow(const BodyPath& body_at);
  /// What put_on has left, where `follow` starts; null before.
  const std::shared_ptr<const WornCloth>& worn() const { return worn_; }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Also when what falls freely has made all further work vain.
  bool is_late() const { return !falling_.empty() || seconds() > options_.time_budget; }
  /// Time or iterations are used up.
  bool over(int more_iterations = 0) const {
    return is_late() || iterations_ + more_iterations > most_iterations_;
  }
  const Garment& level_garment(int layer) const { return layers_[layer].garment->levels[level_]; }
  int layers() const { return static_cast<int>(layers_.size()); }
  int levels() const { return static_cast<int>(layers_.front().garment->levels.size()); }
  bool is_finest() const { return level_ + 1 == levels(); }
  const std::vector<Triangle>& triangles() const { return model_->mesh().triangles; }
  /// GarmentHierarchy::parents of the next finer level, all layers numbered through.
  std::vector<std::array<int, 2>> parents_of_next() const;

  void make_model(double stiffness_share = 1, bool with_friction = true);
  /// Off the grid of the field the energy of contact jumps: a wider one where cloth has come near.
  void keep_cloth_in_field();
  /// Settles the current level; true when the tolerance was met.
  bool settle(double tolerance, int iterations, double first_dt, bool preparing = false);
  void dress(const PosedBody& body);
  /// Seeded smooth shift of the start, for repeats.
  void perturb();
  /// Shifts and twists the garment on the trunk as the options ask.
  void displace();
  /// Takes the cloth along with the body from where it stands to body_at(1), in steps that are each
  /// settled to a loose tolerance, and halved where the cloth would come to lie deep in the skin.
  void walk(const BodyPath& body_at);
  void settle_levels();
  /// Whether this failed, and there is time and a way for settle_from_pad.
  bool may_try_again(const Certificate& certificate) const;
  /// Another way to rest where the first one failed: the cloth is lifted off the skin by the pad,
  /// its contacts and friction are forgotten, and it settles anew.
  void settle_from_pad();
  /// From anywhere near to the last digits, with rounds that free cuts into the skin.
  void settle_finest();
  /// Carries positions to the next finer level. Midpoints on the coarse edges give the same
  /// surface, so no new intersections; then they move towards the smooth surface through the coarse
  /// normals (PN triangles, Vlachos et al. 2001) as far as they meet nothing.
  void refine();
  /// The same on the way to another posture: instead of being smoothed, the finer level gets back
  /// what set it apart from the coarser one in the worn state, as far as it meets nothing, and its
  /// friction: what its contacts have slid on the moving skin since then.
  void refine_as_worn();
  /// Certifies the cloth as it is or, where that is not settled, as it was at its best. `given_up`:
  /// why it ended, when that is not how the last settling did.
  Drape finish(const std::string& given_up = "");
  std::string how_it_ended() const;

  const std::vector<ClothLayer>& layers_;
  const DrapeOptions& options_;
  Progress& progress_;
  Clock::time_point start_ = Clock::now();
  int level_ = 0, iterations_ = 0;
  int most_iterations_ = std::numeric_limits<int>::max();  ///< of iterations_
  std::string part_ = "dress";                             ///< of the run, for the report
  std::vector<Vec3> x_;
  std::shared_ptr<const ContactBody> body_;
  /// Those whose field the cloth has left: states that are kept may still ask it.
  std::vector<std::shared_ptr<const ContactBody>> outgrown_;
  std::unique_ptr<ClothModel> model_;
  std::unique_ptr<FreeFall> free_fall_;     ///< of the garments of this level
  std::string falling_;                     ///< what falls past the body, in words; else empty
  std::unique_ptr<Integrator> integrator_;  ///< of model_
  IntegratorKind integrator_kind_ = IntegratorKind::quasi_static;
  SettleOutcome last_;
  SettleReport report_;

  /// A state of the finest level on the last body, to come back to.
  struct Kept {
    std::vector<Vec3> x;
    ClothMemory memory;
    double residual;
    int held_off_triangles = 0;
    std::string ended = {};  ///< empty: as the run does
  };
  void keep(std::optional<Kept>& kept, double residual);
  std::optional<Kept> lowest_;     ///< that of the lowest residual, cuts or not
  std::optional<Kept> clear_;      ///< that of the lowest residual among those found free of cuts
  std::optional<Kept> first_try_;  ///< the best that was there before settle_from_pad

  std::vector<WornCloth::Level> handed_on_;  ///< by put_on: the coarser levels, then all
  std::shared_ptr<const WornCloth> worn_;
};

}  // namespace loosefit
