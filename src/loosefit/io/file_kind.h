#pragma once
#include <string>

namespace loosefit::io {

/// What a file is that is no sewing pattern of a kind that can be read, by its content: "a DXF
/// file", "an SVG drawing", "a mesh (PLY)", "a FreeSewing file", …; empty when it is none of those
/// that people have garments in. Looks at no more than the beginning.
std::string kind_of_file(const std::string& bytes);

}  // namespace loosefit::io
