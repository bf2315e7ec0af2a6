#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape_garment.h"
#include "loosefit/drape/posed_body.h"
#include "loosefit/solver/integrator.h"

namespace loosefit {

/// A garment, or several worn over each other, on the way to rest, and on to other postures: knows
/// the state of the cloth, the body under it, the clock, the report and whom to tell. Keeps
/// references to all arguments of the constructor.
class ClothRun {
 public:
  /// \throws InvalidInput for no layers, or layers of different edge lengths.
  ClothRun(const std::vector<ClothLayer>& layers, const DrapeOptions& options, Progress& progress);

  /// Dress and settle, as drape_garment. What it leaves is where `follow` starts.
  Drape put_on(const BodyPath& body_at);
  /// As DrapeSession::follow.
  Drape follow(const BodyPath& body_at);

 private:
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  const Garment& level_garment(int layer) const { return layers_[layer].garment->levels[level_]; }
  int layers() const { return static_cast<int>(layers_.size()); }
  int levels() const { return static_cast<int>(layers_.front().garment->levels.size()); }
  bool is_finest() const { return level_ + 1 == levels(); }
  const std::vector<Triangle>& triangles() const { return model_->mesh().triangles; }

  void make_model(double stiffness_share = 1, bool with_friction = true);
  /// Settles the current level; true when the tolerance was met.
  bool settle(double tolerance, int iterations, double first_dt, bool preparing = false);
  void dress(Body body);
  /// Seeded smooth shift of the start, for repeats.
  void perturb();
  /// Shifts and twists the garment on the trunk as the options ask.
  void displace();
  /// Takes the cloth along with the body from where it stands to body_at(1), in steps of at most
  /// that turn of any skin [rad], each settled to a loose tolerance.
  void walk(const BodyPath& body_at, double step, double tolerance, int iterations);
  void settle_levels();
  /// From anywhere near to the residual `fine`, with rounds that free cuts into the skin.
  void settle_finest(double fine);
  /// Carries positions to the next finer level. Midpoints on the coarse edges give the same
  /// surface, so no new intersections; then they move towards the smooth surface through the coarse
  /// normals (PN triangles, Vlachos et al. 2001) as far as they meet nothing.
  void refine();
  Drape finish();

  const std::vector<ClothLayer>& layers_;
  const DrapeOptions& options_;
  Progress& progress_;
  Clock::time_point start_ = Clock::now();
  int level_ = 0, iterations_ = 0;
  std::string part_ = "dress";  ///< of the run, for the report
  std::vector<Vec3> x_;
  std::shared_ptr<const PosedBody> body_;
  std::unique_ptr<ClothModel> model_;
  SettleOutcome last_;
  SettleReport report_;

  /// The state at the end of put_on.
  struct Worn {
    std::vector<Vec3> x;
    std::shared_ptr<const PosedBody> body;
    ClothMemory memory;
  };
  std::optional<Worn> worn_;
};

}  // namespace loosefit
