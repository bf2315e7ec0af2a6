#pragma once
#include <filesystem>
#include <string>

#include "loosefit/study/set_aside.h"

namespace loosefit::study {

/// Writes study-report.html and study-report.json into a folder that is there. The page ends with
/// the digests of both, by which they are known as they were written: what is not known so, as
/// somebody has changed or written it, is set aside first as NAME.changed-1 … Nobody else may write
/// there meanwhile. \throws IoError
void write_report_files(const std::filesystem::path& folder, const std::string& html,
                        const std::string& json, const SetAside& tell);

}  // namespace loosefit::study
