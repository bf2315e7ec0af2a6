#include "loosefit/report/write_lines.h"

#include "loosefit/io/scenario_attachment.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pattern/notch.h"
#include "loosefit/pipeline/case_sewn_parts.h"
#include "loosefit/report/lines_plan.h"

namespace loosefit::report {
namespace {

std::vector<garment::Attachment> cables_of(const pipeline::CaseResult& result) {
  std::vector<garment::Attachment> all;
  for (const pipeline::CaseLine& line : result.lines)
    for (const placement::SiteSpec& site : result.scenario.sites) {
      if (!site.line || site.name != line.name) continue;
      const auto cables =
          pipeline::cables_along(line.name, *site.line, line.course, result.studied().mesh(),
                                 result.studied().pattern.pattern);
      all.insert(all.end(), cables.begin(), cables.end());
    }
  return all;
}

}  // namespace

std::vector<io::PatternMark> line_marks_of(const pipeline::CaseResult& result) {
  std::vector<io::PatternMark> marks;
  for (const garment::Attachment& cable : cables_of(result))
    marks.push_back({cable.name, cable.panel, std::get<garment::Cable>(cable.part).path, false});
  return marks;
}

void write_lines(const std::filesystem::path& folder, const pipeline::CaseResult& result) {
  io::write_text_file((folder / kLinesPlan).string(), lines_plan_svg(result));
  std::string toml =
      "# The lines of this run as cables, for a scenario with the same pattern. A cable that "
      "stands for a\n"
      "# line with a stiffness of its own takes the place of that [[site]], or it would be sewn on "
      "twice.\n";
  for (const garment::Attachment& cable : cables_of(result))
    toml += "\n" + io::attachment_toml(cable);
  io::write_dxf(folder / kLinesDxf, result.studied().pattern.pattern, {}, line_marks_of(result));
  io::write_text_file((folder / kLinesCables).string(), toml);
}

}  // namespace loosefit::report
