#include "loosefit/report/glossary.h"

namespace loosefit::report {

const std::vector<GlossaryTerm>& glossary() {
  static const std::vector<GlossaryTerm> terms = {
      {"residual", "Residual ‖F‖/‖W‖",
       "Net force left on the cloth, root of the sum of squares over all free vertices, over that "
       "of their weights. At rest it is zero; a drape counts as settled up to 0.001. "
       "(docs/theory/solver.md 1.)"},
      {"residual-max", "Largest on one particle",
       "Net force on the vertex where it is greatest, over the mean weight of a vertex; at most "
       "0.1 of a settled drape."},
      {"crossings", "Crossings",
       "Pairs of triangles that intersect, by an exact test: cloth with body, cloth with itself. "
       "Cloth that is folded flat on itself counts too. A settled drape has none."},
      {"stable", "Stable",
       "Whether the balance is a minimum of the energy, so that a small push brings the cloth "
       "back, "
       "or a saddle that it would leave. Asked by the Hessian of the energy."},
      {"worn", "Worn",
       "Every limb goes through its opening, and no opening has left its place on the body."},
      {"can-be-put-on", "Can be put on",
       "Whether each opening, with its cloth as long as it is known to give, lets pass what has "
       "to: head, hands, heels, chest or hips. A pattern does not tell zips and buttons: a "
       "garment that needs one is worn all the same. (docs/outputs.md.)"},
      {"stopped", "Stopped", "Why the solver ended: converged, or what ran out."},
      {"iterations", "Iterations", "Newton steps of all parts of the run, on all meshes."},
      {"line-elongation", "Elongation of a line",
       "Length of the sensor as worn over its own length, minus 1: of the whole in the reference "
       "posture, the greatest of all states, and the greatest of any part. (docs/theory/lines.md "
       "2.)"},
      {"line-strain", "Strain of a route",
       "Stretch of the cloth along the way, either way, of parts of 10 mm: the greatest in any "
       "state. "
       "(docs/theory/lines.md 5.)"},
      {"line-swing", "Swing",
       "Greatest less least signal of all postures of one donning; the signal is the length over "
       "that "
       "in the reference posture, minus 1."},
      {"line-slack", "Slack of a line",
       "Share of the line whose parts are shorter than by themselves by 0.5 % or more, at worst."},
      {"line-contact", "Contact of a line", "Share of its length that touches the skin, at worst."},
      {"line-donnings", "Donnings",
       "By how much its length in the reference posture changes from the first donning to another, "
       "as "
       "a share of its length as cut."},
      {"line-bend", "Bend radius",
       "Least radius to which the cloth bends along the line in any state."},
      {"line-tension", "Tension", "Greatest tension of the stiffness that was told for the line."},
      {"line-score", "Score of a line",
       "By the scorecards of lines: the least of all its needs, from 0 (fails) to 1 (good), in its "
       "worst donning. (docs/scorecards.md.)"},
      {"bgm", "Fit (BGM)",
       "Body-garment mobility: girth of the flat garment over girth of the body at the same level, "
       "minus 1. 0.10 is 10 % loose, a negative value is tight. (Harms, Amft and Tröster 2012.)"},
      {"ease", "Ease",
       "Garment girth over body girth minus 1 at a station: asked, what the scenario wanted; cut, "
       "what the flat pieces have."},
      {"normal-force", "Normal force",
       "Sum of what the body pushes on the cloth, friction left out [N]. A garment that hangs "
       "presses with a few times its weight."},
      {"near-share", "Share of the cloth near the skin",
       "Share of the flat area whose gap to the skin is at most the given distance."},
      {"measured-range", "Measured range",
       "Elongation or shear up to which the constants of the cloth were measured. Beyond it its "
       "forces are extrapolated."},
      {"footprint", "Value under a sensor",
       "Mean over the footprint of the sensor on the cloth, in brackets the value that 95 % of it "
       "stay below. The footprint of a site without one of its own is a disc of 12 mm radius."},
      {"uv", "Place in the pattern",
       "u along the weft, v along the warp of the flat piece, from its own origin [mm]."},
      {"address", "Anatomical address",
       "Body segment and three ratios in percent of axes between palpable landmarks (UNISEP, "
       "Shirazi "
       "et al. 2024), of the skin under the point in the reference posture. It means the same on "
       "every person."},
      {"partner", "Partner on the body",
       "The nearest point of the skin on the same or a neighbouring limb that faces the same way "
       "as "
       "the cloth."},
      {"region", "Region",
       "Part of the body under the cloth, left and right as the wearer has them."},
      {"percentiles", "5 %, median, 95 %",
       "Values that 5, 50 and 95 % of the flat area stay below. The area mean weighs every value "
       "by the flat cloth that it stands for."},
      {"robust", "Score",
       "Each need of the sensor gives 1 where it is met, 0 where it fails, and a straight line "
       "between; the score of a drape is the least of them. The robust score is the 5th percentile "
       "over all drapes (donnings, bodies), with few drapes the worst. "
       "(docs/theory/sensor_metrics.md 8, 12.)"},
      {"interval", "90 % interval",
       "Where the number lies in 90 % of the bootstrap draws over the drapes (Efron 1979). With "
       "few "
       "drapes a robust score can only be better than the worst one seen."},
      {"passing", "Passing", "Share of the drapes in which the site reaches the pass mark."},
      {"turns", "Turns of a sensor",
       "By how much a sensor that was calibrated in the first posture has turned against the skin "
       "in the posture in which it turns most, about its own three axes, right-handed: across it, "
       "along its axis, and about the outward normal of the cloth [deg]."},
      {"mark", "Mark",
       "Number of the row, beside the place on the garment and on its pattern. Sites that cannot "
       "be "
       "told apart share a rank; each has a mark of its own."},
      {"rank", "Rank",
       "By robust score. Sites share a rank (2=) when either order comes up in more than a fifth "
       "of "
       "the bootstrap draws."},
      {"limited", "Limited by", "The need that gives the site its score: what to improve first."},
      {"tolerance", "Tolerance",
       "How far the sensor may be sewn off its place, along and around the limb, and keep 90 % of "
       "its score: the dashed ellipse in the pattern."},
      {"crushed", "Crushed and torn triangles",
       "Triangles of which a yarn direction is shorter than half its flat length, or longer than "
       "the cloth bears. The drape is at rest there all the same, but their strain is that of a "
       "mesh that is too coarse for a fold or a corner of the cut: do not read it."},
      {"slip", "Slip",
       "How far the cloth has moved along the skin since the reference posture, against the skin "
       "that lay under it there [mm]. Arrows lead from where the cloth would be had it gone along, "
       "to where it is."},
      {"pressure-force", "Pressure by force",
       "What the body pushes on the cloth per worn area [kPa], mean over the cloth that touches."},
      {"pressure-tension", "Pressure by tension",
       "Membrane tension times the curvature of the body under the cloth, plus the cloth's weight "
       "across it [kPa]: the generalised Laplace law."},
      {"slope", "Slope of the folds",
       "Root mean square tilt of the cloth out of its shape smoothed over 30 mm [deg]."},
      {"coherence", "Coherence of the folds",
       "1 when all folds run alike, 0 when no direction is preferred."},
      {"bending-length", "Bending length",
       "Cube root of the bending rigidity over the weight per area [mm]: how far cloth stands out "
       "before it hangs."},
      {"repeat-spread", "Spread over repeats",
       "Sample standard deviation of a number over drapes from other starts."},
      {"mesh", "Mesh",
       "Vertices and triangles of the garment the maps were made on. Halve edge_length of the "
       "scenario to see how much a number depends on it."},
  };
  return terms;
}

}  // namespace loosefit::report
