#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/known_garment.h"

namespace loosefit::pattern {

/// Two runs of edges that may be sewn together.
struct SeamProposal {
  ChainSeam seam;
  double first = 0, second = 0;  ///< lengths [m]
  double cost = 0;               ///< 0: nothing speaks against it
  std::string why;               ///< what it rests on
};

/// What a pattern without seams may be sewn like.
struct SeamProposals {
  KnownGarment known;               ///< may be none
  std::vector<SeamProposal> seams;  ///< those of the known garment first
  std::vector<std::string> unsewn;  ///< panels that no proposal joins to another
};

/// Proposes seams. Where the garment is known by its topology, that. Else sections of outlines are
/// paired by least cost: relative difference of length (weight 1), places of notches (1), what the
/// names of the pieces say (1), directions against the grain (0.5), and whether the mirrored twins
/// can be sewn alike (2). Pairs that cost more than leaving both sides open are none.
/// Matching lengths alone finds 8 of 20 seams at best, so these are for somebody to confirm.
SeamProposals propose_seams(const Pattern& pattern, const std::vector<Notch>& notches);

}  // namespace loosefit::pattern
