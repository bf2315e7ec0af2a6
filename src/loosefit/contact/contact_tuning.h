#pragma once
#include <cstddef>

namespace loosefit::contact {

// All tuning numbers of contact: constants, since they stand in inner loops. Those of a material
// (stiffness, friction, thickness) are arguments of the energies. A number without a reason was
// found by trial and has not been swept.

/// Pressure law of the compressed layer between cloth and body (compress_layer).
struct LayerTuning {
  /// Share of the offset from which the layer hardens, and the factor of the hardening.
  double onset = 0.6, hardening = 20;
  /// Share from which the pressure grows linearly: at it the layer bears 25 k o
  /// (120 kPa in thin cotton), so that not even the points of a shoulder or a breast
  /// reach the skin; a finite stiffness, since cloth may start from within the skin.
  double hardest = 0.85;
};

/// Signed distance field of the body (DistanceField).
struct FieldTuning {
  /// Spacing of the grid in every drape [m] (docs/decisions/0005).
  double spacing = 0.005;
  /// Most nodes of the grid (100 MB); a region that needs more gets a coarser grid
  /// (DistanceField::is_coarsened), each time by `coarsening`.
  double max_nodes = 2e7, coarsening = 1.25;
  /// Half width of the sampled band in cells, and of its rim, where the interpolant may lack nodes
  /// and gives way to the surface itself.
  double band_cells = 4.2, rim_cells = 2;
  /// How much less than at the nearest node the interpolant can be, in cells: half a cell's
  /// diagonal off, from node values that fall off as steeply as distances can.
  double largest_fall = 1.6;
};

/// Coulomb friction with lagged normal forces (Friction).
struct FrictionTuning {
  /// How far the anchor may trail during the iterations on one static balance, in stick reaches.
  /// Longer memory lets more of a slide come back.
  double memory = 100;
  /// Iterations for which a lost contact of cloth with cloth keeps its anchor. Pairs follow each
  /// other as cloth slides over cloth; without an end they would pile up.
  int lost_iterations = 50;
  /// Under-relaxation of a normal force: the smallest share of a change that is taken, the factor
  /// of the share where the force turns back, and where it does not. Aggregate relaxation (Silva
  /// and Almeida 1990), contact by contact: ends cycles of
  /// contacts that open and close in turn.
  double min_relaxation = 0.05, relaxation_decrease = 0.5, relaxation_increase = 1.5;
};

/// Broad phase: lists of candidate pairs (CandidatePairs).
struct BroadPhaseTuning {
  /// Margin of a list in mean edge lengths: wide enough to last for many calls, narrow enough to
  /// leave out the next but one neighbours in an unfolded sheet.
  double margin = 0.25;
  /// After a long move (rms above long_move margins) the next one will not be like it: the margin
  /// of its list is smaller by the factor.
  double long_move = 0.5, long_move_margin = 0.1;
  /// A list made for a long move is long itself: made anew once moves are shorter by this factor.
  double short_again = 0.25;
  /// Share of the particles that may leave the margin before a new list is made.
  double max_outliers = 0.02;
  /// By how much quick tests are wider than what they stand for [m]: above the round-off of
  /// coordinates of metres.
  double rounding = 1e-12;
};

/// Continuous collision detection (time_of_impact).
struct ImpactTuning {
  /// Share of the distance that that a step keeps at least.
  double kept_distance = 0.1;
  /// Advances end when they gain less than this share of the kept distance.
  double min_gain = 1e-3;
  /// A conservative stop: the bound stays valid.
  int max_advances = 200;
};

/// Barrier between features of cloth (SelfContact).
struct BarrierTuning {
  /// p₀ [Pa]. At half the reach the barrier then bears 5 kPa, as the linear part of the layer on
  /// the skin does at half the thickness (ClothModelTuning::layer_pressure), at nine tenths 130 Pa.
  double pressure = 4000;
  /// Mollifier threshold of edges that are nearly parallel, times both squared rest lengths (Li et
  /// al. 2020, section 4.2).
  double parallel_threshold = 1e-3;
  /// Share of the reach below which the turning of the normal counts in a projected matrix: left
  /// out, Newton slides features along each other so far that they meet on the bend.
  double pressed = 0.5;
  /// Blocks that a pattern may hold beyond twice those in use before it shrinks (StickyPattern), so
  /// that the pattern of a few contacts is not made anew at every change.
  std::size_t pattern_slack = 2000;
};

struct ContactTuning {
  LayerTuning layer;
  FieldTuning field;
  FrictionTuning friction;
  BroadPhaseTuning broad_phase;
  ImpactTuning impact;
  BarrierTuning barrier;
};

constexpr bool is_valid(const ContactTuning& t) {
  const auto is_share = [](double value) { return value > 0 && value < 1; };
  return is_share(t.layer.onset) && t.layer.hardening >= 0 && is_share(t.layer.hardest) &&
         t.layer.hardest > t.layer.onset && t.field.spacing > 0 && t.field.max_nodes > 1000 &&
         t.field.max_nodes < 2147483647 && t.field.coarsening > 1 && t.field.rim_cells >= 2 &&
         t.field.band_cells > t.field.rim_cells && t.field.largest_fall > 0.866 &&
         t.friction.memory >= 1 && t.friction.lost_iterations >= 0 &&
         is_share(t.friction.min_relaxation) && is_share(t.friction.relaxation_decrease) &&
         t.friction.relaxation_increase > 1 && t.broad_phase.margin > 0 &&
         t.broad_phase.long_move > 0 && is_share(t.broad_phase.long_move_margin) &&
         is_share(t.broad_phase.short_again) && is_share(t.broad_phase.max_outliers) &&
         t.broad_phase.rounding > 0 && is_share(t.impact.kept_distance) &&
         is_share(t.impact.min_gain) && t.impact.max_advances > 0 && t.barrier.pressure > 0 &&
         is_share(t.barrier.parallel_threshold) && is_share(t.barrier.pressed);
}

inline constexpr ContactTuning kContact;
static_assert(is_valid(kContact));

}  // namespace loosefit::contact
