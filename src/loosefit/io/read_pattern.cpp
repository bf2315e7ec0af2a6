#include "loosefit/io/read_pattern.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/seams_file.h"

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

PatternFile read_pattern(const std::filesystem::path& path, const DxfWish& wish,
                         const std::filesystem::path& seams) {
  if (kind_of_file(beginning(path)) == "a DXF file") {
    PatternFile result = read_dxf_pattern(path, wish);
    std::error_code ignored;
    const std::filesystem::path beside = seams_path(path);
    if (!seams.empty() || std::filesystem::exists(beside, ignored)) {
      const std::filesystem::path& from = seams.empty() ? beside : seams;
      read_seams(from, result.pattern, result.warnings);
      result.about.push_back("seams from " + from.string());
    }
    return result;
  }
  for (const auto& [key, value] : {std::pair{"size", wish.size}, std::pair{"units", wish.units},
                                   std::pair{"seams", seams.string()}})
    if (!value.empty())
      throw InvalidInput({path.string(), 0, key}, '"' + printable(value) + '"',
                         "none: only DXF files have sizes and units to choose from, and no seams");
  return read_garmentcode(path);
}

}  // namespace loosefit::io
