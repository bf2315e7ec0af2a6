#pragma once
#include <memory>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_path.h"
#include "loosefit/drape/cloth_layer.h"
#include "loosefit/drape/drape.h"
#include "loosefit/drape/drape_options.h"

namespace loosefit {

/// One donning: a garment is put on once and then follows its wearer from posture to posture.
///
/// Every posture is reached from the state in which put_on left cloth and friction, not from the
/// posture before it: a sensor is calibrated in one posture and judged in others, so each is the
/// same way from there, whatever else is on the list, and one that fails spoils no other.
class DrapeSession {
 public:
  /// Garments worn over each other, the innermost first; positions and forces of its drapes are
  /// those of all layers in turn (drape_of_layer). Keeps references to the garments, and to
  /// progress until put_on is done. \throws InvalidInput for no layers, or layers meshed at
  /// different edge lengths.
  DrapeSession(std::vector<ClothLayer> layers, const DrapeOptions& options, Progress& progress);
  /// The same with one garment.
  DrapeSession(const GarmentHierarchy& garment, Material material, const DrapeOptions& options,
               Progress& progress);
  ~DrapeSession();
  DrapeSession(const DrapeSession&) = delete;
  DrapeSession& operator=(const DrapeSession&) = delete;

  /// As drape_garment; its body_at(1) is the posture in which the wearer then stands.
  Drape put_on(const BodyPath& body_at);

  /// The body moves from where put_on left it to body_at(1), body_at giving the way; the cloth goes
  /// along with the skin and rubs on it in steps, then settles on the finest level as after
  /// put_on. Not dressed again. The time budget of the options holds for each call. Does not throw
  /// when it fails to settle. Several may be under way at the same time, with `budget` times the
  /// time for each. \throws Error before put_on; Cancelled.
  Drape follow(const BodyPath& body_at, Progress& progress, double budget = 1) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Dress, then settle: garment levels coarse to fine on the body; returns the finest level's drape.
/// Does not throw when it fails to settle: the certificate says why.
/// Calls progress.stage("dress") and progress.stage("settle").
/// \throws GeometryError if the garment cannot be put on (no arms for sleeves, …), Cancelled.
Drape drape_garment(const GarmentHierarchy& garment, const Material& material,
                    const BodyPath& body_at, const DrapeOptions& options, Progress& progress);

}  // namespace loosefit
