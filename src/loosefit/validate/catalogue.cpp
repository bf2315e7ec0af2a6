#include "loosefit/validate/catalogue.h"

namespace loosefit::validate {

std::vector<Benchmark> benchmarks() {
  return {
      {"M1", "Homogeneous strain on an irregular mesh",
       "docs/theory/validation.md 1.3 a: closed form", true, benchmark_homogeneous_strain},
      {"M2", "Forces and stiffness are derivatives of the energy",
       "docs/theory/validation.md 1.1: finite differences", true, benchmark_derivatives},
      {"M3", "Strip cut at an angle", "docs/theory/validation.md 6.3: orthotropic compliance", true,
       benchmark_off_axis},
      {"B1", "Heavy cantilever",
       "docs/theory/validation.md 4.1: heavy elastica θ″ = −Γ s cos θ; “cantilever” of Romero et "
       "al. 2021",
       true, benchmark_heavy_cantilever},
      {"B2", "Cantilever test of fabrics", "docs/theory/validation.md 4.2: heavy elastica at Γ = 8",
       true, benchmark_overhang},
      {"B3", "Cantilever with a load on its end",
       "docs/theory/validation.md 4.3: elastica (α = 1: Bisshopp and Drucker 1945)", true,
       benchmark_tip_load},
      {"B4", "Self-buckling of an upright strip", "docs/theory/validation.md 4.4: linear buckling",
       true, benchmark_self_buckling},
      {"B5", "Ring, pear and heart loops", "docs/theory/validation.md 4.5: heavy elastica", true,
       benchmark_loops},
      {"B6", "Pure twist of a square plate", "docs/theory/validation.md 2.2, 4.9: Kirchhoff plate",
       true, benchmark_twist_plate},
      {"B7", "Lateral buckling of a cantilever plate on edge",
       "docs/theory/validation.md 4.8: Ritz solutions for the test of Romero et al. 2021", true,
       benchmark_lateral_buckling},
      {"B8", "Bending does not see the mesh", "docs/theory/validation.md 2.1: energy of cylinders",
       true, benchmark_bending_direction},
      {"B9", "Residual curvature after release",
       "docs/theory/validation.md 2.3: KES loop M = B kappa +- HB", true,
       benchmark_residual_curvature},
      {"C1", "Block on an incline", "docs/theory/validation.md 3.1: Coulomb", true,
       benchmark_incline},
      {"C2", "Belt over a cylinder", "docs/theory/validation.md 3.2: capstan", true,
       benchmark_capstan},
      {"C3", "Strip pressed on a frictional floor",
       "docs/theory/validation.md 4.6: clamped–hinged elastica (set-up of Sano, Yamaguchi and Wada "
       "2017)",
       true, benchmark_stick_slip},
      {"C4", "Ruck on a frictional floor", "docs/theory/validation.md 4.7: heavy elastica", true,
       benchmark_ruck},
      {"C5", "Sleeve on a cylinder", "docs/theory/validation.md 6.2: closed form", true,
       benchmark_sleeve},
      {"D1", "Cusick drape of an elastic sheet",
       "docs/theory/validation.md 5.3: energy minima with hinges", true, benchmark_cusick_drape},
      {"D2", "Drape of measured fabrics",
       "docs/theory/validation.md 5.2: Matsudaira, Masuda, Wada and Yokura 2015", true,
       benchmark_measured_fabrics},
      {"T1", "Free fall with the integrator of the paper", "docs/theory/validation.md 7", true,
       benchmark_free_fall},
      {"T2", "Swing of a hanging strip", "docs/theory/validation.md 7: zeros of J0 (Bernoulli)",
       true, benchmark_hanging_swing},
      {"G1", "Gap and angular deviation of an eccentric tube",
       "docs/theory/validation.md 8: two circles", true, benchmark_eccentric_tube},
      {"S1", "Four sensors on the back", "Harms, Amft and Tröster 2012, section 3", false,
       benchmark_back_sensors},
  };
}

}  // namespace loosefit::validate
