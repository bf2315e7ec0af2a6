#pragma once
#include <string>

#include "loosefit/garment/attachment.h"
#include "loosefit/io/config_reader.h"

namespace loosefit::io {

/// One [[attachment]]: a board or a cable.
garment::Attachment read_attachment_section(ConfigReader table);
/// What a board is made of: mass, thickness, side, material, measured figures.
void read_board_make(ConfigReader& table, garment::BoardMake& board);
/// The same as keys of an inline table, without what has no value.
std::string board_make_toml(const garment::BoardMake& board);
/// An attachment as TOML.
std::string attachment_toml(const garment::Attachment& attachment);

}  // namespace loosefit::io
