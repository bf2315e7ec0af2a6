#pragma once

namespace loosefit::solver {

/// What solving took: counters, and wall seconds of its parts.
struct SolverWork {
  int iterations = 0, factorisations = 0;
  int regional = 0;      ///< steps of a few particles by themselves (RegionRelaxation); without
                         ///< their factors
  double assemble = 0;   ///< matrices
  double factorise = 0;  ///< their factors
  double solve = 0;      ///< solutions with them
  double collide = 0;    ///< continuous collision detection of search directions
  double evaluate = 0;   ///< energies and forces
  double refresh = 0;    ///< contact sets and friction at new places
  double region = 0;     ///< all that regional steps took

  SolverWork& operator+=(const SolverWork& other) {
    iterations += other.iterations;
    factorisations += other.factorisations;
    regional += other.regional;
    assemble += other.assemble;
    factorise += other.factorise;
    solve += other.solve;
    collide += other.collide;
    evaluate += other.evaluate;
    refresh += other.refresh;
    region += other.region;
    return *this;
  }
};

}  // namespace loosefit::solver
