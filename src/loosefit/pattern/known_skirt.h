#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/known_pieces.h"

namespace loosefit::pattern {

/// A skirt of two or more gores, sewn side to side.
struct KnownSkirt {
  std::vector<std::pair<int, KnownPiece>> pieces;  ///< panel, what it is; in the order of the seams
  std::vector<ChainSeam> seams;
  std::vector<OpenLoop> loops;      ///< waist, hem
  std::vector<std::string> doubts;  ///< why nobody should sew it unasked
  bool unnamed = false;             ///< no name says which gores are before and which behind

  bool found() const { return !pieces.empty(); }
};

/// The skirt that these panels are, where their sides are alike by 2 %: of two groups of panels
/// with different sides the larger one, of as many those that are no strips, then the longer ones.
/// They go round from right to left before the wearer, and back behind her, as names say (front,
/// back, left, right); without names in the order of the file, the first half before. Doubts: no
/// names, gores of one place that are not alike, gores that taper.
KnownSkirt know_skirt(const Pattern& pattern, const std::vector<int>& panels);

/// What speaks against the way up a piece of a skirt is drawn: it is narrower below than above.
std::vector<std::string> way_up_doubt(const Panel& panel, const KnownPiece& piece);

/// Whether a hole is named for the neck, or a head may pass it and no name says otherwise.
bool may_be_neck(const PanelHole& hole);

/// Why pieces that are told as a skirt (one a panel) may be of a top: by a name, or by a hole that
/// a head may pass or that is named for the neck.
std::vector<std::string> top_doubts(const Pattern& pattern, const std::vector<KnownPiece>& pieces);

}  // namespace loosefit::pattern
