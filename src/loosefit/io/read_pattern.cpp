#include "loosefit/io/read_pattern.h"

#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/garmentcode_read.h"

namespace loosefit::io {
namespace {

/// Enough of a file to tell its kind; empty when it cannot be read, which its reader then tells.
std::string beginning(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string text(1 << 16, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

}  // namespace

PatternFile read_pattern(const std::filesystem::path& path, const DxfWish& wish) {
  if (kind_of_file(beginning(path)) == "a DXF file") return read_dxf_pattern(path, wish);
  for (const auto& [key, value] : {std::pair{"size", wish.size}, std::pair{"units", wish.units}})
    if (!value.empty())
      throw InvalidInput({path.string(), 0, key}, '"' + printable(value) + '"',
                         "none: only DXF files have sizes and units to choose from");
  return read_garmentcode(path);
}

}  // namespace loosefit::io
