#include "loosefit/report/write_report.h"

#include "loosefit/base/version.h"
#include "loosefit/io/text_file.h"
#include "loosefit/report/html.h"
#include "loosefit/report/page_viewer.h"
#include "loosefit/report/report_style.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {

std::string report_html(const pipeline::CaseResult& result,
                        const std::vector<render::Picture>& pictures,
                        const placement::RankingTable* ranking) {
  return report_html(result, CaseForms(result), pictures, ranking);
}

std::string report_html(const pipeline::CaseResult& result, const CaseForms& forms,
                        const std::vector<render::Picture>& pictures,
                        const placement::RankingTable* ranking) {
  // A drape that is not to be relied on says so before it is shown.
  const bool holds = result.certificate().holds();
  const std::string proof = certificate_section(result) + unsettled_section(result);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>Loosefit report</title>\n<style>" +
         std::string(kReportStyle) + "</style>\n" + viewer_head() + "</head>\n<body>\n" +
         headline_section(result) + (holds ? "" : warning_section(result) + proof) +
         answer_section(result) + (holds ? warning_section(result) : "") + viewer_section(result) +
         picture_section(result, pictures) + ranking_section(ranking) + site_section(result) +
         line_section(result) + (holds ? proof : "") + wear_section(result) +
         fit_check_section(result) + layer_section(result) + map_section(result) +
         wrinkle_section(result) + pressure_section(result) + repeat_section(result) +
         fit_section(result) + definition_section(result) + provenance_section(result) +
         element("p", "Made by Loosefit " + escaped(version()) + ".", "lead") +
         viewer_data(result, forms, ranking) + "</body>\n</html>\n";
}

void write_report(const std::filesystem::path& dir, const pipeline::CaseResult& result,
                  const CaseForms& forms, const std::vector<render::Picture>& pictures,
                  const placement::RankingTable* ranking) {
  io::write_text_file((dir / "report.html").string(),
                      report_html(result, forms, pictures, ranking));
}

}  // namespace loosefit::report
