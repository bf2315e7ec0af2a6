#pragma once
#include <filesystem>

#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// Reads a pattern file of any kind that is known, told by its content: GarmentCode JSON, DXF-AAMA
/// and ASTM D6673, SVG of FreeSewing, Inkscape and others, FreeSewing JSON, and .val of Valentina,
/// which is asked to export it (io/valentina.h). Files that do not say what is sewn take their
/// seams from a side file (io/seams_file.h): `seams`, else NAME.seams.toml beside them where there
/// is one. Without seams there a garment of known topology is sewn as that, where there is one way
/// only (pattern/known_garment.h); nothing else is sewn by guess. Sewn pieces without a placement,
/// those of GarmentCode files that lie in a heap (pattern/heap.h) included, are placed by what they
/// are (pattern/place_pieces.h); where that cannot be told, `not_placed` says why. \throws as the
/// readers and read_seams; InvalidInput for a size, units or seams that are asked of a file that
/// has them itself.
PatternFile read_pattern(const std::filesystem::path& path, const PatternWish& wish = {},
                         const std::filesystem::path& seams = {});

/// The same without seams and placement where the file has none: what seams are proposed for.
PatternFile read_unsewn(const std::filesystem::path& path, const PatternWish& wish = {});

}  // namespace loosefit::io
