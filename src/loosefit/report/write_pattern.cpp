#include "loosefit/report/write_pattern.h"

#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/pattern_svg.h"
#include "loosefit/io/run_folder.h"

namespace loosefit::report {

void write_pattern(const std::filesystem::path& folder, const pattern::Pattern& pattern) {
  io::RunFolder files = io::RunFolder::add(folder, "pattern");
  io::write_garmentcode(files.path() / "pattern.json", pattern);
  io::write_pattern_svg(files.path() / "pattern.svg", pattern);
  files.commit();
}

}  // namespace loosefit::report
