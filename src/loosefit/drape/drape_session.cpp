#include "loosefit/drape/drape_session.h"

#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/drape/recoveries.h"
#include "loosefit/drape/settle_garment.h"

namespace loosefit::drape {

struct DrapeSession::State {
  State(std::vector<ClothLayer> garments, const DrapeOptions& o, Progress& progress)
      : layers(std::move(garments)), options(o) {
    cloth.emplace(layers, options, recoveries(), progress);
  }
  std::vector<ClothLayer> layers;
  DrapeOptions options;
  std::optional<ClothState> cloth;  ///< until it is put on
  std::shared_ptr<const WornCloth> worn;
};

DrapeSession::DrapeSession(std::vector<ClothLayer> layers, const DrapeOptions& options,
                           Progress& progress)
    : state_(std::make_unique<State>(std::move(layers), options, progress)) {}

DrapeSession::DrapeSession(const garment::GarmentHierarchy& garment, fabric::Material material,
                           const DrapeOptions& options, Progress& progress)
    : DrapeSession({{&garment, std::move(material)}}, options, progress) {}

DrapeSession::~DrapeSession() = default;

Drape DrapeSession::put_on(const body::BodyPath& path, const body::BodyPath& wide_path,
                           Movements movements) {
  if (state_->worn) throw Error("a garment is put on once in a drape session");
  state_->cloth->movements = std::move(movements);
  Drape drape = dress_and_settle(*state_->cloth, path, wide_path, state_->worn);
  state_->cloth.reset();  // all but what is worn would only take memory
  return drape;
}

Drape DrapeSession::follow(const body::BodyPath& path, Progress& progress, int at_once) const {
  if (!state_->worn) throw Error("a garment has to be put on before it can follow its wearer");
  DrapeOptions options = state_->options;
  options.drapes_at_once = at_once;
  ClothState cloth(state_->layers, options, recoveries(), progress);
  return follow_wearer(cloth, path, state_->worn);
}

Drape drape_garment(const garment::GarmentHierarchy& garment, const fabric::Material& material,
                    const body::BodyPath& path, const DrapeOptions& options, Progress& progress) {
  return DrapeSession(garment, material, options, progress).put_on(path);
}

}  // namespace loosefit::drape
