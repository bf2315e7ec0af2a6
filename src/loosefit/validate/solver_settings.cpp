#include "loosefit/validate/solver_settings.h"

#include <fmt/format.h>

#include "loosefit/solver/integrator.h"
#include "loosefit/solver/solver_tuning.h"
#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

std::vector<std::pair<std::string, std::string>> solver_settings() {
  const solver::SettleOptions settle;
  const solver::LineSearchTuning search;
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
                   "per step, {} halvings of a step; the exact second derivative of bending, "
                   "where drapes take a cheaper one to the same equilibrium",
                   settle.first_dt, 1e3 * settle.max_move, search.max_backtracks)},
      {"at rest",
       fmt::format("net force over weight (root of the sum of squares over all free particles; "
                   "without weight in newtons, or against the applied load) at most {:g}, but for "
                   "B5 under little weight (up to 4e-5), B7 (1e-4, let go 1e-5), C1 (laying "
                   "down: 1e-9), C2 (heavy strips 1e-5, let go 1e-4), C4 (1e-5), D1 (scaling: "
                   "1e-9), D2 (lowering: 1e-4); without weight, M3 (1e-10 and 1e-8 N) and B9 "
                   "(1e-8 N)",
                   kBenchTolerance)},
      {"contact",
       fmt::format("distance field of the body on a grid of {:g} mm; friction sticks elastically "
                   "within {:g} mm before it slides",
                   1e3 * contact::kFieldSpacing, 1e3 * drape::SettlingTuning{}.cloth.stick_reach)},
      {"threads",
       "each benchmark runs on one; the figures do not depend on how many run at a time"},
  };
}

}  // namespace loosefit::validate
