#pragma once
#include <optional>
#include <vector>

#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/curve_chain.h"

namespace loosefit::kinds {

/// Half of a torso piece, x ≥ 0 from the centre line, y = 0 at the high point shoulder.
struct TorsoHalf {
  pattern::CurveChain neck;      ///< centre → shoulder
  pattern::CurveChain shoulder;  ///< neck → shoulder point
  pattern::CurveChain armhole;   ///< shoulder point → underarm
  pattern::CurveChain side;      ///< underarm → hem, or to where it is cut for a dart
  pattern::CurveChain dart_above, dart_below;  ///< of a dart: side → tip, tip → side; else empty
  pattern::CurveChain side_below;              ///< below the cut → hem; empty without one
  pattern::CurveChain hem;                     ///< side → centre, or to a dart in it
  /// Of a back with waist darts (back_waist.h): hem → tip, tip → hem, and from there the rest of
  /// the hem → centre, whose first part ends at the dart; else empty.
  pattern::CurveChain back_dart_outer, back_dart_inner, hem_middle;
  double shoulder_x = 0, armhole_depth = 0;
};

/// The edge of the neck of both pieces together fits the neck base: as wide, as deep behind, and as
/// deep in front as its length asks for. A neckband ends there, and is sewn on as much farther out
/// all round as it is wide.
struct NeckOpening {
  double half_width = 0;                 ///< of the pieces, at the shoulder seam [m]
  double shoulder = 0;                   ///< how far the shoulder seam begins below the HPS [m]
  double drop_front = 0, drop_back = 0;  ///< of the pieces, below the HPS [m]
};
NeckOpening fit_neck(const ShirtMeasures& measures, const ShirtFit& fit);
/// Half of that edge on the front or on the back, centre → shoulder, of the pieces.
pattern::CurveChain draft_neck_half(const ShirtMeasures& measures, const ShirtFit& fit, bool front);

/// Slope of the shoulder seam in the pieces [rad]: flatter than the body's shoulder, which lies
/// behind the pit of the neck and before C7, so that the way from there to the shoulder point is
/// longer than it is seen from the front (docs/theory/patterns.md 2).
double seam_slope(const ShirtMeasures& measures);

/// Half the shoulder breadth of the pieces: where the body's shoulder seam ends, and in part where
/// a loose chest takes it [m].
double shoulder_half_width(const ShirtMeasures& measures, const ShirtFit& fit);
/// The same of the body, flat.
double shoulder_half_width(const ShirtMeasures& measures);

/// How much lower than behind the hem ends at the sides, so that it is level when worn [m]: the way
/// down over the sides lies midway between those over front and back.
double hem_side_drop(double front_balance);

/// docs/theory/patterns.md 2. `underarm_depth`: underarm below the body's shoulder point; `drop`:
/// extra half shoulder width [m].
TorsoHalf draft_torso_half(const ShirtMeasures& measures, const ShirtFit& fit,
                           double underarm_depth, bool front, double drop);

/// Levels of a torso piece of which the side seam is drawn.
struct TorsoLevels {
  double chest = 0, waist = 0, hip = 0;           ///< girths of the body [m]
  double chest_fit = 0, hip_fit = 0;              ///< mobilities
  std::optional<double> waist_fit;                ///< absent: as the body needs
  double front_fullness = 0;                      ///< as ShirtMeasures
  double underarm_y = 0, waist_y = 0, hem_y = 0;  ///< [m], upwards
  GirthLine trunk = {};    ///< of the body between waist and ends, as GirthsAlong; may be empty
  double side_drop = 0;    ///< by which the side seams end below the level of the hem [m]
  double back_intake = 0;  ///< what darts of the back take in at the waist (back_waist.h) [m]
};
/// How far the sides of the front lie beyond a quarter of the girth, and those of the back inside
/// of it [m]: a bust needs its width in front, the side seams lie where the body's sides are. On a
/// trunk that is as wide in front as at the side the widest place says nothing of where a tailor
/// would sew it.
double side_shift(const TorsoLevels& levels, bool front);
/// Side seam of half a torso piece, underarm → hem: straight, or through the asked girth of the
/// waist and, where the body is known there and no dart shapes the back, with the ease between the
/// asked ones at every place, or round a belly that a straight seam leaves less room than was asked for above and
/// below. It has the girth of the hem from its level down to its end. Girths are those of the sewn
/// shirt: of what darts of the back take in either half gives back a quarter at the hem and at a
/// waist that is asked for or needed.
pattern::CurveChain draft_side(const TorsoLevels& levels, bool front);

/// What both darts of the back take in at the waist, so that the girth there is less by the
/// intake [m]: where sides run straight, also what they are let out by there for the hem.
double back_opening_at_waist(const TorsoLevels& levels);

/// Hem of half a torso piece, from the side seam to the centre line, level at both ends.
pattern::CurveChain draft_hem(const Vec2& side, double centre_level);

/// Underarm seam of half a sleeve, from (w, 0) at the underarm to the cuff: through the half widths
/// at its levels, with no bend (monotone cubics, Fritsch and Carlson 1980). `width_at`: x at each
/// y, downwards from the underarm.
pattern::CurveChain draft_under_seam(const std::vector<Vec2>& width_at);

/// Half of a sleeve, x ≥ 0 from the top line, y = 0 at the underarm.
struct SleeveHalf {
  pattern::CurveChain cap;    ///< top → underarm
  pattern::CurveChain under;  ///< underarm → cuff, or to where it is cut for a dart
  pattern::CurveChain dart_above, dart_below, under_below;  ///< as TorsoHalf's of the side
  pattern::CurveChain top;                                  ///< cap → cuff
  pattern::CurveChain cuff;                                 ///< top → under
};
/// docs/theory/patterns.md 3; `width_at` as of draft_under_seam.
SleeveHalf draft_sleeve_half(const std::vector<Vec2>& width_at, double cap_height);

/// Half cap from the top (0, h) to the underarm (w, 0) (docs/theory/patterns.md 3).
pattern::CurveChain draft_cap(double width, double height);

/// Cap height and front share such that both half caps have exactly the wanted lengths.
struct CapFit {
  double height = 0, front_share = 0.5;
};
/// Empty when even a flat cap of girth `girth` is longer than the armhole, or the two armholes are
/// too unequal for a front share between 0.3 and 0.7.
std::optional<CapFit> fit_caps(double front_length, double back_length, double girth);

}  // namespace loosefit::kinds
