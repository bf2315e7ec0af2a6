#pragma once
#include <string>

#include "loosefit/garment/attachment.h"
#include "loosefit/io/config_reader.h"

namespace loosefit::io {

/// One [[attachment]]: a board or a cable.
garment::Attachment read_attachment_section(ConfigReader table);
/// The same as TOML.
std::string attachment_toml(const garment::Attachment& attachment);

}  // namespace loosefit::io
