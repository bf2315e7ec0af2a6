#include "loosefit/validate/solver_settings.h"

#include <fmt/format.h>

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/newton.h"
#include "loosefit/validate/specimen.h"

namespace loosefit {

std::vector<std::pair<std::string, std::string>> solver_settings() {
  const SettleOptions settle;
  const Newton::Options newton;
  return {
      {"cloth",
       "the energies of the drape stage: St. Venant-Kirchhoff membrane on constant-strain "
       "triangles, bending with its Poisson ratio, gravity, contact with a body and with itself, "
       "Coulomb friction"},
      {"meshes",
       "the mesher of garments: irregular Delaunay triangles, seams welded, a third of each "
       "triangle's mass on its corners"},
      {"statics",
       fmt::format("pseudo-transient Newton: first pseudo-step {:g} s, at most {:g} mm of movement "
                   "per iteration, {} halvings of a step",
                   settle.first_dt, 1e3 * settle.max_move, newton.max_backtracks)},
      {"at rest",
       fmt::format("net force over weight at most {:g} (root of the sum of squares over all free "
                   "particles); without weight, the same share of the applied load",
                   kBenchTolerance)},
      {"contact",
       fmt::format("distance field of the body on a grid of {:g} mm; friction sticks elastically "
                   "within {:g} mm before it slides",
                   1e3 * kFieldSpacing, 1e3 * kStickReach)},
      {"threads",
       "each benchmark runs on one; the figures do not depend on how many run at a time"},
  };
}

}  // namespace loosefit
