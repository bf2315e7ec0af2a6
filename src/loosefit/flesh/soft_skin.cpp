#include "loosefit/flesh/soft_skin.h"

#include <algorithm>

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/quasi_static.h"

namespace loosefit::flesh {
namespace {

/// 20 mm of flesh of 20 kPa: relaxed limbs have moduli of 10 to 90 kPa (Zheng and Mak 1996).
constexpr double kFoundation = 1e6;    // [Pa/m]
constexpr double kReach = 0.02;        ///< over which a displacement dies out [m]
constexpr double kRim = 1e3;           ///< times as stiff where the skin goes on
constexpr double kFoldPressure = 3e4;  ///< of skin against skin, well inside the gap [Pa]
/// Margin of the lists of contact candidates, in edges: neighbours repel from half of their
/// distance at rest, and a margin as wide as that of cloth would list most of those in a smooth
/// skin.
constexpr double kListMargin = 0.1;
constexpr double kPressure = 200;  ///< left over when it is settled, 0.2 mm of flesh [Pa]
constexpr int kMostIterations = 60;
constexpr double kStatic = 1e4;  ///< first pseudo-step: no inertia [s]

}  // namespace

SoftSkin::SoftSkin(const SkinPatch& patch, const particles::VectorField& rest,
                   particles::VectorField x, particles::VectorField target)
    : x_(std::move(x)),
      springs_(patch.triangles, stiffness(patch, rest), kFoundation * kReach * kReach),
      contact_(patch.triangles, area_, static_cast<int>(rest.size()), folds(rest)) {
  springs_.set_target(std::move(target));
  system_.energies = {&springs_, &contact_};
  system_.mass = weight_;
  system_.gravity = 1;
}

std::vector<double> SoftSkin::stiffness(const SkinPatch& patch,
                                        const particles::VectorField& rest) {
  std::vector<double> k(rest.size());
  weight_.assign(rest.size(), 0);
  for (const auto& [a, b, c] : patch.triangles) {
    area_.push_back(0.5 * (rest[b] - rest[a]).cross(rest[c] - rest[a]).norm());
    for (int v : {a, b, c}) {
      k[v] += kFoundation * area_.back() / 3;
      weight_[v] += kPressure * area_.back() / 3;
    }
  }
  for (std::size_t i = 0; i < k.size(); ++i)
    if (patch.on_rim[i]) k[i] *= kRim;
  return k;
}

contact::SelfContact::Options SoftSkin::folds(const particles::VectorField& rest) const {
  contact::SelfContact::Options options;
  options.thickness = body::kSkinGap;
  options.pressure = kFoldPressure;
  options.friction = 0;
  options.list_margin = kListMargin;
  options.rest = rest;
  return options;
}

void SoftSkin::follow(particles::VectorField target, Progress* progress) {
  particles::VectorField way(x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i) way[i] = target[i] - springs_.target()[i];
  const double share = contact_.max_step(x_, way);
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += share * way[i];
  springs_.set_target(std::move(target));
  solver::SettleOptions options;
  options.tolerance = 1;
  options.max_iterations = kMostIterations;
  options.first_dt = kStatic;
  // Where much is folded an iteration takes a second.
  options.watch = [&](int, double) {
    if (progress) {
      progress->update(0, "skin folds");
      progress->check_cancelled();
    }
    return false;
  };
  solver::make_quasi_static(system_)->settle(x_, options);
}

}  // namespace loosefit::flesh
