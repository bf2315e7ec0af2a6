#pragma once
#include <set>
#include <string>

#include "loosefit/kinds/trousers/trousers_measures.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// Trousers: four pieces, front and back of each leg, with seams outseam_*, inseam_*, centre_front
/// and centre_back, and a waistband of two strips sewn on with stretch. Pattern y is the height
/// above the floor [m]. Each piece lies about its crease line, x = 0; the crotch curve reaches
/// beyond the middle of the body by fit.crotch_width of the girth of the hip, three tenths of it in
/// front, as drafting books divide it (Aldrich 2008). Front and back of a seam are equally long, or
/// within 2 mm (trousers_seams.h). `measures` and `fit` as the kind names them; `asked`: keys of
/// the fit that somebody asked for, which are complained of before others. \throws InvalidInput for
/// measures that do not make a garment together.
pattern::Pattern draft_trousers(const char* kind, const BodyMeasures& measures,
                                const NamedValues& fit, const std::set<std::string>& asked = {});

}  // namespace loosefit::kinds
