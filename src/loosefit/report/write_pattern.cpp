#include "loosefit/report/write_pattern.h"

#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/pattern_svg.h"
#include "loosefit/io/run_folder.h"

namespace loosefit::report {

void write_pattern(const std::filesystem::path& folder, const pattern::Pattern& pattern,
                   const std::vector<pattern::Notch>& notches,
                   const std::vector<io::PatternMark>& marks) {
  io::RunFolder files = io::RunFolder::add(folder, "pattern");
  io::write_garmentcode(files.path() / "pattern.json", pattern);
  io::write_pattern_svg(files.path() / "pattern.svg", pattern);
  io::write_dxf(files.path() / "pattern.dxf", pattern, notches, marks);
  files.commit();
}

}  // namespace loosefit::report
