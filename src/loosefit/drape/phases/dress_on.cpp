#include "loosefit/drape/phases/dress_on.h"

#include <cmath>
#include <random>

#include "loosefit/drape/phases/sew_on.h"
#include "loosefit/dress/dress_layers.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::drape {
namespace {

/// Seeded smooth shift of the start, for repeats.
void perturb(ClothState& state) {
  const DrapeOptions& options = state.options;
  if (!(options.start_perturbation > 0)) return;
  std::mt19937_64 rng(options.seed);
  std::normal_distribution<double> normal(0, options.start_perturbation);
  const Vec3 shift(normal(rng), normal(rng), normal(rng));
  const double phase = 2 * kPi * std::uniform_real_distribution<double>(0, 1)(rng);
  const DisturbTuning& wave = state.tuning.disturb;
  for (Vec3& p : state.x)
    p += shift * (1 + wave.wave_amplitude *
                          std::sin(wave.wave_height * p[2] + wave.wave_width * p[0] + phase));
}

}  // namespace

void lay_round_body(ClothState& state) {
  const body::PosedBody body = state.path(0);
  std::vector<dress::LayerToDress> to_dress;
  for (int l = 0; l < state.layer_count(); ++l) {
    const garment::Garment& garment = state.garment(l);
    const pattern::Pattern& pattern = state.layers[l].garment->pattern;
    const bool has_wider = state.wide_path && state.attempts[RecoveryKind::wide_posture] == 0;
    const auto sew = [&garment, &pattern, has_wider](const body::PosedBody& wearer) {
      return sew_on(garment, pattern, wearer, has_wider);
    };
    to_dress.push_back({&garment, kinds::garment_kind(pattern.kind).lay, sew});
  }
  try {
    state.x = dress::dress_layers(to_dress, body);
  } catch (const dress::NoRoom& error) {
    state.no_room = error.what();
    return;
  }
  state.no_room.clear();
  perturb(state);
  state.body = with_field(body, bounds(state.x), contact::kFieldSpacing, state.tuning.carry);
}

void dress_on(ClothState& state) {
  lay_round_body(state);
  state.recover(RecoveryPoint::dressed);
  if (!state.no_room.empty()) throw dress::NoRoom(state.no_room);
}

}  // namespace loosefit::drape
