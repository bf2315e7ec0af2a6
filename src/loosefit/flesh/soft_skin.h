#pragma once
#include "loosefit/base/progress.h"
#include "loosefit/body/facing_skin.h"
#include "loosefit/contact/self_contact.h"
#include "loosefit/flesh/skin_patch.h"
#include "loosefit/flesh/skin_springs.h"
#include "loosefit/solver/particle_system.h"

namespace loosefit::flesh {

/// A patch of skin that is drawn to its targets and folds without passing through itself.
class SoftSkin {
 public:
  /// rest: positions of all vertices of the patch from which areas and distances of neighbours are
  /// taken; x, target: positions now, and where their springs pull them [m].
  SoftSkin(const SkinPatch& patch, const particles::VectorField& rest, particles::VectorField x,
           particles::VectorField target);
  SoftSkin(const SoftSkin&) = delete;
  SoftSkin& operator=(const SoftSkin&) = delete;

  /// Moves the targets, takes the skin along as far as it meets nothing, and lets it settle.
  /// \throws Cancelled by `progress`, if there is one.
  void follow(particles::VectorField target, Progress* progress = nullptr);
  const particles::VectorField& positions() const { return x_; }
  const particles::VectorField& target() const { return springs_.target(); }

 private:
  std::vector<double> stiffness(const SkinPatch& patch, const particles::VectorField& rest);
  contact::SelfContact::Options folds(const particles::VectorField& rest) const;

  particles::VectorField x_;
  std::vector<double> area_;    ///< of the triangles [m²]
  std::vector<double> weight_;  ///< against which forces on the vertices are measured [N]
  SkinSprings springs_;
  contact::SelfContact contact_;
  solver::ParticleSystem system_;
};

}  // namespace loosefit::flesh
