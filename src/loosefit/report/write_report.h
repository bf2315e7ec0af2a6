#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"
#include "loosefit/render/render_pictures.h"
#include "loosefit/report/case_forms.h"

namespace loosefit::report {

/// The report of one case as one self-contained HTML page: no scripts, no outside resources, the
/// pictures embedded; dark on light, fits a phone and a sheet of paper. Parts: who wears what, the
/// certificate (or a red banner when the drape is sealed), pictures of every map side by side, the
/// numbers per map, region and site, postures and donnings, the ranking where there is one, fit,
/// body, material, timings, versions and the resolved scenario. A result without maps or pictures
/// gets a page without those parts. \throws IoError when a picture cannot be read.
std::string report_html(const pipeline::CaseResult& result,
                        const std::vector<render::Picture>& pictures,
                        const placement::RankingTable* ranking = nullptr);
/// The same with forms that are there already.
std::string report_html(const pipeline::CaseResult& result, const CaseForms& forms,
                        const std::vector<render::Picture>& pictures,
                        const placement::RankingTable* ranking);

/// Writes it to DIR/report.html. \throws IoError when the file cannot be written in full.
void write_report(const std::filesystem::path& dir, const pipeline::CaseResult& result,
                  const CaseForms& forms, const std::vector<render::Picture>& pictures,
                  const placement::RankingTable* ranking = nullptr);

}  // namespace loosefit::report
