#pragma once
#include <filesystem>
#include <string>

#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// How the warnings about panels without translation or rotation end.
inline constexpr char kMissingPose[] = ": missing, taken as [0, 0, 0]";

/// GarmentCode specification JSON (Korosteleva and Sorkine-Hornung 2023; pygarment 2.0.2).
/// Read in full: straight, quadratic, cubic and circle edges, the old list form and absolute
/// coordinates; units_in_meter; pose X = Rz Ry Rx x + t; loops closed by index or by position;
/// either winding (a clockwise piece is mirrored and turned round so that its outside stays
/// outside); right_wrong, darts, gathers; panel_order or its rule. y-up file frame → our frame.
/// Missing keys that have a usual value are warnings. Consecutive edges of one panel with the same
/// extra key "name" are one seam unit (our writer splits chains of curves).
/// A pattern that our draft made is known by its mark and by how it is sewn (Panel::part), whatever
/// its panels are called. Keys that are not read are told in the warnings. Files of other kinds
/// (DXF, SVG, meshes, …) are refused by their kind.
/// `file` only appears in messages.
/// \throws InvalidInput with file and line (syntax) or JSON path, GeometryError for outlines that
///         cannot be cloth.
PatternFile parse_garmentcode(const std::string& text, const std::string& file);
/// \throws IoError if the file cannot be read, and as parse_garmentcode.
PatternFile read_garmentcode(const std::filesystem::path& path);

}  // namespace loosefit::io
