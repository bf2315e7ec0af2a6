#include "loosefit/report/write_report.h"

#include "loosefit/base/version.h"
#include "loosefit/io/text_file.h"
#include "loosefit/report/html.h"
#include "loosefit/report/report_style.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {

std::string report_html(const study::CaseResult& result,
                        const std::vector<render::Picture>& pictures,
                        const placement::RankingTable* ranking) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>Loosefit report</title>\n<style>" +
         std::string(kReportStyle) + "</style>\n</head>\n<body>\n" + headline_section(result) +
         certificate_section(result) + unsettled_section(result) + fit_check_section(result) +
         layer_section(result) + ranking_section(ranking) + wear_section(result) +
         picture_section(result, pictures) + map_section(result) + wrinkle_section(result) +
         pressure_section(result) + site_section(result) + repeat_section(result) +
         fit_section(result) + definition_section(result) + provenance_section(result) +
         element("p", "Made by Loosefit " + escaped(version()) + ".", "lead") +
         "</body>\n</html>\n";
}

void write_report(const std::filesystem::path& dir, const study::CaseResult& result,
                  const std::vector<render::Picture>& pictures,
                  const placement::RankingTable* ranking) {
  io::write_text_file((dir / "report.html").string(), report_html(result, pictures, ranking));
}

}  // namespace loosefit::report
