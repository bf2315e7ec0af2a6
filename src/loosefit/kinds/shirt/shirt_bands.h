#pragma once
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// Names of the edges of a strip, counter-clockwise from the corner at the lowest x and y.
struct StripEdges {
  const char *below, *right, *above, *left;
};
/// Where a strip lies in its panel [m].
struct StripPlace {
  double x, length, low, high;
};
/// A rectangle of two layers, `stiffness` times as stiff in the plane as one of the fabric, in
/// bending at least as stiff as one.
pattern::Panel folded_strip(const std::string& name, const std::string& label,
                            const StripPlace& place, const StripEdges& edges, double stiffness);

/// Adds the strips that a fit asks for to a shirt whose neck and sleeves leave room for them: a
/// neckband of a front and a back half and a cuff of two halves to each sleeve, with edges seam,
/// rim, and at the ends end_L, end_R or top, under. Each half is shorter than the edge that it is
/// sewn to by the share of the fit. They are rectangles, but for a neckband without stretch, which
/// is what lies between its seam and the edge of a neck without a neckband. Strips have two layers,
/// whose bending rigidity is at least that of one.
void add_bands(pattern::Pattern& shirt, const ShirtMeasures& measures, const ShirtFit& fit);

/// Notes the hems of a fit on all edges of a shirt that are neither sewn nor of a band.
void finish_edges(pattern::Pattern& shirt, const ShirtFit& fit);

}  // namespace loosefit::kinds
