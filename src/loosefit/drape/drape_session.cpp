#include "loosefit/drape/drape_session.h"

#include <tbb/global_control.h>

#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/drape/cloth_run.h"

namespace loosefit {

struct DrapeSession::State {
  State(std::vector<ClothLayer> garments, const DrapeOptions& o, Progress& progress)
      : layers(std::move(garments)),
        options(o),
        run(std::make_unique<ClothRun>(layers, options, progress)) {
    if (options.threads > 0)
      threads.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
  }
  std::vector<ClothLayer> layers;
  DrapeOptions options;
  std::optional<tbb::global_control> threads;
  std::unique_ptr<ClothRun> run;  ///< until it is put on
  std::shared_ptr<const WornCloth> worn;
};

DrapeSession::DrapeSession(std::vector<ClothLayer> layers, const DrapeOptions& options,
                           Progress& progress)
    : state_(std::make_unique<State>(std::move(layers), options, progress)) {}

DrapeSession::DrapeSession(const GarmentHierarchy& garment, Material material,
                           const DrapeOptions& options, Progress& progress)
    : DrapeSession({{&garment, std::move(material)}}, options, progress) {}

DrapeSession::~DrapeSession() = default;

Drape DrapeSession::put_on(const BodyPath& body_at) {
  if (state_->worn) throw Error("a garment is put on once in a drape session");
  Drape drape = state_->run->put_on(body_at);
  state_->worn = state_->run->worn();
  state_->run.reset();  // all but what is worn would only take memory
  return drape;
}

Drape DrapeSession::follow(const BodyPath& body_at, Progress& progress, double budget) const {
  if (!state_->worn) throw Error("a garment has to be put on before it can follow its wearer");
  DrapeOptions options = state_->options;
  options.time_budget *= budget;
  return ClothRun(state_->layers, options, state_->worn, progress).follow(body_at);
}

Drape drape_garment(const GarmentHierarchy& garment, const Material& material,
                    const BodyPath& body_at, const DrapeOptions& options, Progress& progress) {
  return DrapeSession(garment, material, options, progress).put_on(body_at);
}

}  // namespace loosefit
