#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// Whether the garment has all parts of the built-in shirt (pattern/shirt_parts.h), whatever its
/// panels are called.
bool is_shirt(const Garment& garment);

/// First positions of a shirt round a body [m]: seen from the front every panel is laid out flat
/// over the limb that it will cover, front panels pass before the body and back panels behind it,
/// seams closed at the silhouette. The result encloses the body and has no intersections with
/// itself; it is strained, and settling lets it contract.
/// \throws NoRoom when the body cannot be dressed in this posture, GeometryError for a pattern or a
/// body that is not fit for it.
std::vector<Vec3> dress_shirt(const Garment& shirt, const Body& body);

/// First positions of any other garment [m]: the placement that its pattern file gives to the
/// panels, seams closed at the mean of their sides. Panels that cut each other or lie in the body
/// are moved along their outside normals, by up to 0.3 m, until none does (of two that look the
/// same way, the later one); seams that then still pass through the body are left to contact.
/// \throws GeometryError when that does not part them, or the pattern lacks a panel.
std::vector<Vec3> dress_as_placed(const Garment& garment, const Pattern& pattern,
                                  const TriangleMesh& body);

/// One garment of those that are worn over each other.
struct LayerToDress {
  const Garment* garment = nullptr;
  const Pattern* pattern = nullptr;  ///< where is_shirt does not hold: the placement
};

/// First positions of garments worn over each other, the innermost first: vertices of all in turn.
/// Each as if alone (dress_shirt, dress_as_placed), but every shirt with more room than the layer
/// under it, so that its sheets pass before and behind those, and its seams beside them. Nothing
/// cuts anything. \throws as the above, and NoRoom when shirts cut each other.
std::vector<Vec3> dress_layers(const std::vector<LayerToDress>& layers, const Body& body);

}  // namespace loosefit
