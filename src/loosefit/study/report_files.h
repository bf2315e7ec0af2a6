#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace loosefit::study {

/// Writes study-report.html and study-report.json into a folder that is there. The page ends with
/// the digests of both, by which they are known as they were written: what somebody has changed
/// since, or written, is set aside first as NAME.changed-1 … Returns the names that it has now.
/// \throws IoError
std::vector<std::filesystem::path> write_report_files(const std::filesystem::path& folder,
                                                      const std::string& html,
                                                      const std::string& json);

}  // namespace loosefit::study
