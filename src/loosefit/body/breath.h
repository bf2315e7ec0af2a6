#pragma once
#include "loosefit/body/body.h"

namespace loosefit::body {

/// The body with its chest wider by the share `growth` of its girth: an inhalation. The chest
/// deepens forward of the line from pelvis to neck, most at three fifths of the way up, dying out
/// smoothly to both ends and to the arms; ribs that rise like a pump handle do that, while the
/// sideways part (bucket handle) is left out, so that hanging arms need not move. Maps, normals and
/// landmarks go along; joints and measures stay. \throws InvalidInput for a body without the joints
/// "pelvis", "neck", "shoulder_L" and "shoulder_R", or whose chest cannot be found.
Body inhaled(Body body, double growth);

/// Girth of the trunk by tape at the level where `inhaled` moves it most, square to the line from
/// pelvis to neck, without arms [m].
double breathing_girth(const Body& body);

}  // namespace loosefit::body
