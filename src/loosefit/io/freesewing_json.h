#pragma once
#include <filesystem>
#include <string>

#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// Reads a drafted FreeSewing design as JSON: what getRenderProps() of its Pattern gives
/// ("stacks"), or {"parts": [{"DESIGN.PART": {"paths": …}}]}. Of each part the largest path
/// that is called "seam" or of class "fabric" is the sew line, as drawn_freesewing has it, from
/// which SVG of the same design gives the same pieces; millimetres, y down. Half pieces are
/// unfolded. Settings alone, from which FreeSewing drafts, are no pattern. `file` only appears in
/// messages. \throws InvalidInput with file and JSON path; GeometryError for no sound piece.
PatternFile parse_freesewing_json(const std::string& text, const std::string& file,
                                  const PatternWish& wish = {});
/// \throws IoError if the file cannot be read, and as parse_freesewing_json.
PatternFile read_freesewing_json(const std::filesystem::path& path, const PatternWish& wish = {});

}  // namespace loosefit::io
