#pragma once
#include <filesystem>
#include <string>

#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// Key of "properties" that tells by which draft of ours a pattern was made (GarmentKind::mark);
/// readers of other programs pass over it.
inline constexpr const char* kDraftKey = "loosefit_draft";

/// Keys of ours in a panel, what it is made of ("mass", "membrane", "bending": Panel::cloth) and
/// its holes ("name", "points": Panel::holes), over which other programs go as if they were cloth;
/// and in an edge, the width of its hem (PanelEdge::finish) and its elastic ("ratio", "stiffness"
/// in newtons, "width": PanelEdge::elastic).
inline constexpr const char *kClothKey = "loosefit_cloth", *kHolesKey = "loosefit_holes",
                            *kFinishKey = "loosefit_finish", *kElasticKey = "loosefit_elastic";

/// The pattern as GarmentCode JSON text in centimetres. Chains of curves are cut where one curve of
/// either side of the seam ends, so that each file edge has one curve and each stitch equal parts.
/// What is written and read again is written as the same bytes. \throws GeometryError for an
/// invalid pattern.
std::string garmentcode_text(const pattern::Pattern& pattern);
/// \throws IoError if the file cannot be written.
void write_garmentcode(const std::filesystem::path& path, const pattern::Pattern& pattern);

}  // namespace loosefit::io
