#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// A seam between two runs of edges, each run in the direction in which the outlines of its panels
/// are drawn: a sleeve's cap to the two armholes it is set into.
struct ChainSeam {
  std::string name;
  std::vector<Stitch::Side> first, second;
  bool reversed =
      false;  ///< start meets start; otherwise the end of one meets the start of the other
  double begin =
      0;  ///< of closed runs: share of the second's length where the first begins, 0 to 1
};

/// Length of a run [m].
double chain_length(const Pattern& pattern, const std::vector<Stitch::Side>& chain);

/// Adds seams. Where an edge begins within the other run, edges are cut there, by shares of the
/// length of the runs (within 3 mm of an end: at the end), so that each stitch joins one edge to
/// one; the parts of edge e3 are e3_1, e3_2. Every edge is in one seam at most.
/// Notches move along with their edges. \throws GeometryError for an empty run, and for one that is
/// not closed by the other seams where `begin` says that it is.
void sew_chains(Pattern& pattern, std::vector<ChainSeam> seams, std::vector<Notch>& notches);

}  // namespace loosefit::pattern
