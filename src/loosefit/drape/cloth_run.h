#pragma once
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/drape_garment.h"
#include "loosefit/drape/posed_body.h"
#include "loosefit/solver/integrator.h"

namespace loosefit {

/// A garment on its way to rest: knows the state of the cloth, the body under it, the clock, the
/// report and whom to tell. Keeps references to all arguments of the constructor.
class ClothRun {
 public:
  ClothRun(const GarmentHierarchy& garment, const Material& material, const BodyPath& body_at,
           const DrapeOptions& options, Progress& progress)
      : garment_(garment),
        material_(material),
        body_at_(body_at),
        options_(options),
        progress_(progress) {}

  /// Dress and settle, as drape_garment.
  Drape drape();

 private:
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  const Garment& level_garment() const { return garment_.levels[level_]; }
  bool is_finest() const { return level_ + 1 == static_cast<int>(garment_.levels.size()); }

  void make_model(double stiffness_share = 1, bool with_friction = true);
  /// Settles the current level; true when the tolerance was met.
  bool settle(double tolerance, int iterations, double first_dt, bool preparing = false);
  void put_on();
  /// Seeded smooth shift of the start, for repeats.
  void perturb();
  void assume_posture();
  void settle_levels();
  /// Carries positions to the next finer level. Midpoints on the coarse edges give the same
  /// surface, so no new intersections; then they move towards the smooth surface through the coarse
  /// normals (PN triangles, Vlachos et al. 2001) as far as they meet nothing.
  void refine();
  Drape finish();

  const GarmentHierarchy& garment_;
  const Material& material_;
  const BodyPath& body_at_;
  const DrapeOptions& options_;
  Progress& progress_;
  Clock::time_point start_ = Clock::now();
  int level_ = 0, iterations_ = 0;
  std::string part_ = "dress";  ///< of the run, for the report
  std::vector<Vec3> x_;
  std::unique_ptr<PosedBody> body_;
  std::unique_ptr<ClothModel> model_;
  SettleOutcome last_;
  SettleReport report_;
};

}  // namespace loosefit
