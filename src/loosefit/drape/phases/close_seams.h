#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "loosefit/drape/arrange_panels.h"

namespace loosefit::drape {

/// How the closing of seams ended.
struct ClosedSeams {
  std::vector<Vec3> x;  ///< of the sewn garment, seams at the mean of their sides [m]
  double gap = 0;       ///< widest that was left between partners [m]
  int iterations = 0;
  int cuts = 0;                              ///< pairs of triangles that still cut each other
  int first_cuts = 0;                        ///< before they were smoothed
  std::pair<int, int> first_cut = {-1, -1};  ///< triangles
  std::optional<int> in_limb;  ///< vertex of a seam that has not come round a limb: deep in it
};

/// Sews a garment that lies in its open panels round the body. The panels
/// are soft as rubber meanwhile; threads pull partners together (SeamPull), the skin keeps the
/// cloth out, and every panel is drawn along `outside`, its own outside normal, so that the tubes
/// that it is sewn into stand open. Shoulders are held up, so that they go over those of the body.
/// Panels pass through each other on the way, which ends with all of them drawn apart; what cuts
/// even then is smoothed. pull: along `outside` [Pa].
ClosedSeams close_seams(const garment::Garment& sewn, const garment::OpenSeams& open,
                        const ArrangedPanels& panels, const body::PosedBody& body, double pull);

}  // namespace loosefit::drape
