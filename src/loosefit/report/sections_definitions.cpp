#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit {
namespace {
struct Definition {
  const char* array;
  const char* term;
  const char* meaning;
};

constexpr Definition kDefinitions[] = {
    {"strain_vertical", "Vertical strain",
     "ε = (distance now − distance in the flat pattern) / distance in the flat pattern, over the "
     "mesh "
     "edges round a point, weighted by cos² of their angle to the grain (Harms, Amft and Tröster "
     "2012, section 2.2). Above zero the cloth is stretched along the grain, which hangs "
     "vertically in "
     "the body of the shirt and runs along the arm in a sleeve."},
    {"strain_warp", "Strain along warp and weft, greatest principal strain",
     "|F d| − 1 with the deformation gradient F of each triangle from pattern to space and d the "
     "direction; the principal value is the larger singular value of F minus one. Free of the "
     "mesh's "
     "edge directions."},
    {"distance_mm", "Body-garment distance",
     "From the cloth's middle surface to the nearest point of the body surface on the same or a "
     "neighbouring limb that faces the same way. Cloth that lies on the skin reads half the "
     "fabric's "
     "thickness. The paper's form, to the nearest body particle, is in drape.vtp as "
     "distance_particle_mm; it reads higher the coarser the body mesh is."},
    {"angular_deviation_deg", "Angular deviation",
     "Angle between the garment's normal and the smooth body normal at that nearest point: an "
     "orientation sensor sewn there shows the body's inclination wrongly by at most this much, as "
     "long as nothing is calibrated away."},
    {"pressure_kPa", "Contact pressure",
     "Normal force of the body on a vertex of the cloth, friction left out, over the worn area "
     "that "
     "belongs to the vertex (a third of the triangles round it): p = f / a. The sum of p a is the "
     "total normal force. Zero where nothing touches. The body is rigid; soft tissue would spread "
     "the peaks, so read means over a footprint and not single points."},
    {"pressure_membrane_kPa", "Contact pressure from tension and curvature",
     "p = N : κ + w n, not below zero: N = F S Fᵀ / J the membrane tension per worn length, κ the "
     "curvature tensor of the body under the cloth, carried out to the cloth's middle surface and "
     "positive where the body is convex, w the weight per worn area along the normal (generalised "
     "Laplace law). Where the body is flat or hollow along the pull it is zero: the cloth bridges. "
     "Zero also where the gap exceeds the contact tolerance, the larger of 0.5 mm and three "
     "quarters of the fabric's thickness."},
    {"pressure_difference_kPa", "Difference of the two pressures",
     "The second minus the first, a check of both: zero for a fine mesh on a smooth body."},
    {"slack", "Share of slack cloth",
     "Share of the triangles round a point whose least principal strain is below −0.5 %: cloth "
     "that "
     "is buckled within an element, on which no strain sensor reads."},
    {"tilt_sagittal_deg", "Tilts against the body",
     "The shortest rotation that takes the body's normal to the cloth's, split into the part about "
     "the axis across the body segment (positive where the cloth's normal leans to the far end of "
     "the segment, on the trunk down) and the part about its long axis (positive on the back to "
     "the wearer's right, on the breast to the left). A posture sensor on the back is wrong by the "
     "first."},
    {"twist_deg", "Twist about the normal",
     "What rotation is left after the tilt: the grain of the cloth against the long axis of the "
     "body segment (trunk upwards, elbow to shoulder, wrist to elbow), positive counter-clockwise "
     "seen from outside. The angular deviation does not see it. Not defined where the axis lies "
     "within 15° of the normal, as on top of the shoulders, nor where the joints are not known."},
    {"rotation_deg", "Total rotation against the body",
     "Angle φ of tilt and twist together: cos φ/2 = cos AD/2 · cos twist/2 with AD the angular "
     "deviation. No direction that is fixed in a sensor reads wrong by more, as long as nothing is "
     "calibrated away."},
    {"gap_mm", "Gap",
     "From the cloth's inner face to the skin: the distance less half the fabric's thickness, not "
     "below zero. The colour scale has its ticks at equal steps."},
    {"contact", "Contact",
     "1 where the gap is within the contact tolerance, the larger of 0.5 mm and three quarters of "
     "the fabric's thickness; the area mean is the share of the cloth that touches."},
    {"slip_mm", "Slip on the skin",
     "How far a point of the cloth has moved along the skin since the first posture, against the "
     "skin that was nearest to it there and has moved with the body since; the greatest over the "
     "postures of the first donning. Single postures are in postures/NAME/drape.vtp, with the "
     "parts "
     "along and around the body segment."},
    {"coe_rms_deg", "Calibrated orientation error",
     "How far an orientation sensor that was calibrated in the first posture reads wrong in the "
     "others: the angle of R Rᵣᵀ, with R the rotation of cloth against skin now and Rᵣ then; root "
     "mean square over the postures of the first donning."},
};
}  // namespace

std::string definition_section(const CaseResult& result) {
  std::string list;
  for (const Definition& d : kDefinitions)
    for (const CaseMap& entry : result.maps.maps)
      if (entry.map.array == d.array)
        list += element("dt", escaped(d.term)) + element("dd", escaped(d.meaning));
  if (list.empty()) return {};
  return element("h2", "What the maps mean") + element("dl", list);
}

}  // namespace loosefit
