#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace loosefit::io {

/// One file of a series.
struct PvdEntry {
  std::filesystem::path file;  ///< relative to the series
  double step = 0;             ///< what a viewer steps through
  std::string name;
};

/// ParaView's list of files that belong together (a VTKFile of type Collection).
/// \throws IoError when it cannot be written in full.
void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries);

}  // namespace loosefit::io
