#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/sections.h"
#include "loosefit/pattern/sew_chains.h"

namespace loosefit::pattern {

/// What an open loop of edges of a known garment is.
enum class LoopKind { neck, armhole, wrist, waist, hem };

/// An open loop of edges, in the order of the outlines: the end of one is where the next begins.
struct OpenLoop {
  std::string name;  ///< "neck", "wrist_L", …
  LoopKind kind = LoopKind::hem;
  int side = 0;  ///< of the wearer: +1 left, −1 right, 0 across the middle
  std::vector<Stitch::Side> edges;
};

/// A piece that is sewn to a loop as a band.
struct KnownBand {
  int panel = 0, loop = 0;
  ChainSeam side, ends;  ///< along the loop, and end to end
};

struct KnownBands {
  std::vector<KnownBand> bands;
  std::vector<std::string> doubts;  ///< why nobody should sew them unasked
};

/// Of these panels those that are bands of these loops: strips, at least 2.5 times as long as wide,
/// which are 0.6 to 1.03 times as long as a loop that their name allows. A band begins where its
/// loop does. Doubts: a name that says nothing, loops of more than one kind that fit.
KnownBands know_bands(const Pattern& pattern, const std::vector<int>& panels,
                      const std::vector<OpenLoop>& loops);

}  // namespace loosefit::pattern
