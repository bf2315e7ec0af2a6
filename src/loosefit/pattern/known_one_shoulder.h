#pragma once
#include <optional>
#include <vector>

#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/known_pieces.h"

namespace loosefit::pattern {

inline constexpr char kOneShoulder[] = "one-shoulder top";

/// A trunk that hangs on one shoulder: six sections, the shortest of which is the shoulder, between
/// an armhole that is cut out and an edge that slants over the bare shoulder to the other side,
/// longer by a fifth and flatter than the armhole is; both sides, which end at the underarms, are
/// as long by a fifth. Sets `side`: the hand of the shoulder of a
/// front; a back is the other way round. Sections: hem, side, armhole, shoulder, slant, side where
/// that is positive, hem, side, slant, shoulder, armhole, side otherwise.
std::optional<KnownPiece> as_one_shoulder(const std::vector<Section>& sections);

/// Seams of front and back, whose `side` is as as_one_shoulder sets it.
std::vector<ChainSeam> one_shoulder_seams(const Pattern& pattern, int front,
                                          const KnownPiece& of_front, int back,
                                          const KnownPiece& of_back);
/// The edges that these leave open: hem, armhole and, as the neck, the slants.
std::vector<OpenLoop> one_shoulder_loops(const Pattern& pattern, int front,
                                         const KnownPiece& of_front, int back,
                                         const KnownPiece& of_back);

}  // namespace loosefit::pattern
