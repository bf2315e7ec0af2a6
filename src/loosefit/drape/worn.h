#pragma once
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// Why a garment at x [m] is not worn by `body`: sentences that a tailor understands ("the
/// waistband has slid to the knees", "the left sleeve is empty"); none where it is. Asked are
///
/// * limbs through openings: neck (or the seam of a hood), cuffs, waist and hem (drape/openings.h)
///   go round what they were made for; a cuff beyond the hand counts when its sleeve has the arm in
///   it; the sleeve or leg of a limb that the wearer lacks may hang empty (body/stumps.h); the face
///   of a hood goes round nothing: round the neck, the hood is off the head;
/// * levels: a waist has not slid down from where it was made for by more than half the way from
///   waist to crotch (12 cm on a man of 1.75 m: from the waist to the upper hips, beyond which no
///   hip bone holds it), nor below the widest hip by more than a quarter of that way, and has not
///   risen by more than that way and above the bust; collars are
///   above the breast, armholes at the shoulders. What a waist was made for is the level at which
///   the pattern places it, not above the waist nor below the upper hips; a tube for the trunk may
///   be made for the chest. Neck openings on the shoulders, hems and cuffs may lie where they like;
/// * a tube with two ends goes round what it is placed round: the trunk, the neck (a poncho, whose
///   hem may lie on the arms) or one limb (a stocking, whose upper end has not slid down the limb
///   by more than half the way from waist to crotch); when that is nothing known, whatever is in
///   one end is in the other; the hem of a skirt is not above its waist;
/// * arms are in what is called a sleeve;
/// * a garment that is open in front has its armholes at the shoulders and its edge behind the
/// neck;
/// * the highest opening of an unusual cut, and cloth without openings, has not gone down by more
///   than twice that way since the pattern was placed; heights of a pattern that begins above the
///   wearer's neck are scaled to begin there;
/// * it touches the body somewhere (within 10 mm), unless it lies `over_others`, which may bear it.
///
/// A body without joints is only asked for the touch.
std::vector<std::string> why_not_worn(const garment::Garment& garment,
                                      const pattern::Pattern& pattern, const std::vector<Vec3>& x,
                                      const body::PosedBody& body, bool over_others = false);

/// Waists of a worn garment that lie above the wearer's waist by more than half the way from waist
/// to crotch, and hems of tops that hang less than seven tenths as far from the neck as the cloth
/// between them is long (drape/hem_hang.h), as sentences: a skirt that is too narrow for the hips
/// is worn below the bust, a shirt is gathered above them.
std::vector<std::string> risen_edges(const garment::Garment& garment,
                                     const pattern::Pattern& pattern, const std::vector<Vec3>& x,
                                     const body::PosedBody& body);

/// Openings of an unusual cut, of which why_not_worn does not know what they are for and so does
/// not ask what goes through them, in one sentence; empty without any and for bodies without
/// joints.
std::string unjudged_openings(const garment::Garment& garment, const pattern::Pattern& pattern,
                              const std::vector<Vec3>& x, const body::PosedBody& body);

/// Whether the openings of an unusual cut, of which why_not_worn does not know what they are for,
/// have the same limbs through them at x on `body` as at `first` on the same person in
/// `first_body`; true for bodies without joints. A limb in the sleeve of an opening counts.
bool worn_alike(const garment::Garment& garment, const pattern::Pattern& pattern,
                const std::vector<Vec3>& x, const body::PosedBody& body,
                const std::vector<Vec3>& first, const body::Body& first_body);

}  // namespace loosefit::drape
