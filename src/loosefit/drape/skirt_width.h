#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"

namespace loosefit::drape {

/// Whether a vertex of the skin belongs to an arm or a hand.
bool is_of_arm(const body::Body& body, std::size_t vertex);

/// Cloth that is wider than the way between the hands is squeezed sideways from the waist down to
/// the wrists and below, so that it is sewn between the hands and not round them. It spreads by
/// itself. `of`: the vertices of x [m] that are of the trunk.
void squeeze_between_hands(std::vector<Vec3>& x, const std::vector<int>& of,
                           const body::PosedBody& body);

/// Below the crotch, cloth that is narrower than the body with its legs apart is stretched sideways
/// until its edges lie beside it: threads draw straight, and would draw a seam between the legs. It
/// contracts round them. `of`: as above, of a garment without legs.
void stretch_round_body(std::vector<Vec3>& x, const std::vector<int>& of,
                        const body::PosedBody& body);

/// Cloth that reaches below the floor is squeezed upwards from the crotch down until it hangs over
/// it: what is sewn below would be caught under the soles. It comes down by itself. `of`: as above.
void squeeze_above_floor(std::vector<Vec3>& x, const std::vector<int>& of,
                         const body::PosedBody& body);

}  // namespace loosefit::drape
