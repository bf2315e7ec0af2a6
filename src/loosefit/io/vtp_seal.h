#pragma once
#include <string>

namespace loosefit::io {

/// Last line of a VTP file: an XML comment with the SHA-256 of all bytes before it. A changed or
/// cut file is so refused before VTK's reader, which divides by damaged numbers, sees it.
std::string vtp_seal(const std::string& bytes_before);

/// True when `file` ends with the seal of what stands before it.
bool vtp_seal_matches(const std::string& file);

}  // namespace loosefit::io
