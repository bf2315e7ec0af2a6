#include "loosefit/drape/phases/dress_on.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "loosefit/drape/lay_padded.h"
#include "loosefit/drape/phases/sew_on.h"
#include "loosefit/dress/dress_layers.h"
#include "loosefit/dress/garments_cut.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::drape {
namespace {

constexpr std::uint64_t kSeedStep = 0x9e3779b97f4a7c15;  ///< so that no seed's second is another's

/// Seeded smooth shift of the start, for repeats and for another start.
void perturb(ClothState& state) {
  const DrapeOptions& options = state.options;
  const double shift_rms =
      std::max(options.start_perturbation,
               state.start > 0 ? state.tuning.certify.restart_perturbation : 0.0);
  if (!(shift_rms > 0)) return;
  std::mt19937_64 rng(options.seed + kSeedStep * state.start);
  std::normal_distribution<double> normal(0, shift_rms);
  const Vec3 shift(normal(rng), normal(rng), normal(rng));
  const double phase = 2 * kPi * std::uniform_real_distribution<double>(0, 1)(rng);
  const DisturbTuning& wave = state.tuning.disturb;
  for (Vec3& p : state.x)
    p += shift * (1 + wave.wave_amplitude *
                          std::sin(wave.wave_height * p[2] + wave.wave_width * p[0] + phase));
}

/// Whether something under a layer dresses other limbs than it does.
bool lies_over_other_limbs(const ClothState& state, int layer) {
  const auto kind = [&](int l) -> const kinds::GarmentKind& {
    return kinds::garment_kind(state.layers[l].garment->pattern.kind);
  };
  for (int under = 0; under < layer; ++under)
    if (dress_other_limbs(kind(layer), kind(under))) return true;
  return false;
}

/// `padded`: what lies over garments of other limbs is laid round a wearer who wears padding there,
/// instead of with more room everywhere.
std::vector<dress::LayerToDress> layers_to_dress(ClothState& state, bool padded) {
  std::vector<dress::LayerToDress> to_dress;
  for (int l = 0; l < state.layer_count(); ++l) {
    const garment::Garment& garment = state.garment(l);
    const pattern::Pattern& pattern = state.layers[l].garment->pattern;
    const bool has_wider = state.wide_path && state.attempts[RecoveryKind::wide_posture] == 0;
    const dress::LayRound& lay = kinds::garment_kind(pattern.kind).lay;
    if (padded && lay && lies_over_other_limbs(state, l)) {
      to_dress.push_back({&garment, {}, [&garment, &lay](const body::PosedBody& wearer) {
                            return lay_padded(garment, lay, wearer);
                          }});
      continue;
    }
    const auto sew = [&garment, &pattern, has_wider](const body::PosedBody& wearer) {
      return sew_on(garment, pattern, wearer, has_wider);
    };
    to_dress.push_back({&garment, lay, sew});
  }
  return to_dress;
}

/// First with padding, which leaves everything nearest to the skin.
std::vector<Vec3> laid_round(ClothState& state, const body::PosedBody& body) {
  bool any = false;
  for (int l = 1; l < state.layer_count(); ++l)
    any |= kinds::garment_kind(state.layers[l].garment->pattern.kind).lay &&
           lies_over_other_limbs(state, l);
  if (any) try {
      return dress::dress_layers(layers_to_dress(state, true), body);
    } catch (const dress::NoRoom&) {
    } catch (const dress::GarmentsCut&) {
    }
  return dress::dress_layers(layers_to_dress(state, false), body);
}

}  // namespace

void lay_round_body(ClothState& state) {
  const body::PosedBody body = state.path(0);
  try {
    state.x = laid_round(state, body);
  } catch (const dress::NoRoom& error) {
    state.no_room = error.what();
    return;
  }
  state.no_room.clear();
  perturb(state);
  state.body = with_field(body, bounds(state.x), contact::kFieldSpacing, state.tuning.carry,
                          state.arms_go_up);
}

void dress_on(ClothState& state) {
  lay_round_body(state);
  state.recover(RecoveryPoint::dressed);
  if (!state.no_room.empty()) throw dress::NoRoom(state.no_room);
}

}  // namespace loosefit::drape
