#pragma once
#include <memory>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_path.h"
#include "loosefit/drape/cloth_layer.h"
#include "loosefit/drape/drape.h"
#include "loosefit/drape/drape_options.h"
#include "loosefit/drape/movement.h"

namespace loosefit::drape {

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
  DrapeSession(const garment::GarmentHierarchy& garment, fabric::Material material,
               const DrapeOptions& options, Progress& progress);
  ~DrapeSession();
  DrapeSession(const DrapeSession&) = delete;
  DrapeSession& operator=(const DrapeSession&) = delete;

  /// Dresses the garments at the beginning of `path`, settles them coarse to fine at its end, and
  /// certifies them there. Where they find no room, at the beginning of `wide_path`, if there is
  /// one: the report then says why (SettleReport::no_room). `movements` are made at the end of the
  /// path, before the garments settle there. Does not throw when it fails to settle: the
  /// certificate says why. Calls progress.stage("dress") and progress.stage("settle"). \throws
  /// NoRoom when the garments find no room round the body in any of these postures, GeometryError
  /// if they cannot be put on (no arms for sleeves, …), Cancelled.
  Drape put_on(const body::BodyPath& path, const body::BodyPath& wide_path = {},
               Movements movements = {});

  /// The body moves from where put_on left it to path(1), path giving the way; the cloth goes
  /// along with the skin and rubs on it in steps, then settles on the finest level as after
  /// put_on. Not dressed again. Budget and iterations of the options hold for each call. Does not
  /// throw when it fails to settle. Several may be under way at the same time, `at_once` of them
  /// sharing the threads (DrapeOptions::drapes_at_once). \throws Error before put_on; Cancelled.
  Drape follow(const body::BodyPath& path, Progress& progress, int at_once = 1) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A session of one garment that is put on, and nothing else.
Drape drape_garment(const garment::GarmentHierarchy& garment, const fabric::Material& material,
                    const body::BodyPath& path, const DrapeOptions& options, Progress& progress);

}  // namespace loosefit::drape
