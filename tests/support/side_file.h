#pragma once
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/seams_file.h"
#include "support/dxf_text.h"

namespace loosefit::support {

/// What the work refuses, with its hint; empty if it refuses nothing.
template <class Work>
std::string refusal_of(const Work& work) try {
  work();
  return {};
} catch (const InvalidInput& error) {
  return std::string(error.what()) + " | " + error.hint();
}

/// The T-shirt of gerber_like_dxf() with this side file, tee.seams.toml.
inline pattern::Pattern tee_with_side_file(const std::string& text) {
  io::PatternFile file = io::parse_dxf_pattern(gerber_like_dxf(), "tee.dxf");
  io::parse_seams(text, "tee.seams.toml", file);
  return file.pattern;
}

}  // namespace loosefit::support
