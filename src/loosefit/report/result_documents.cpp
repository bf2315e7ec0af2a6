#include "loosefit/report/result_documents.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "loosefit/io/output_mark.h"
#include "loosefit/report/ranking_output.h"

namespace loosefit::report {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// All files of a run that are ours, relative to its folder.
Json files_of_run(const std::string& folder) {
  Json files = Json::array();
  if (const auto mark = io::read_output_mark(folder); mark && mark->holds("run"))
    for (const auto& entry : mark->sets.at("run")) files.push_back(entry.first);
  return files;
}

}  // namespace

std::string run_document(const FolderOutput& made, const std::string& folder) {
  const drape::Certificate& certificate = made.result.certificate();
  const pipeline::PuttingOn& putting_on = made.result.putting_on;
  const Json files = files_of_run(folder);
  const auto path_if_there = [&](const char* name) {
    for (const Json& file : files)
      if (file == name) return Json((std::filesystem::path(folder) / name).string());
    return Json(nullptr);
  };
  return text_of(
      {{"folder", folder},
       {"summary", path_if_there("summary.json")},
       {"report", path_if_there("report.html")},
       {"holds", certificate.holds()},
       {"settled", certificate.settled()},
       {"worn", certificate.worn()},
       {"worn_reasons", certificate.worn_reasons},
       {"can_be_put_on", putting_on.possible ? Json(*putting_on.possible) : Json(nullptr)},
       {"can_be_put_on_reasons", putting_on.reasons},
       {"stable", certificate.stable ? Json(*certificate.stable) : Json(nullptr)},
       {"residual", certificate.residual},
       {"stop_reason", certificate.stop_reason},
       {"sealed", made.result.sealed()},
       {"warnings", made.result.warnings},
       {"files", files},
       {"set_aside", made.set_aside.empty() ? Json(nullptr) : Json(made.set_aside)}});
}

std::string rank_document(const RankedRuns& ranked) {
  const bool written = !ranked.folder.empty();
  Json json = {
      {"all_hold", ranked.all_hold},
      {"folder", written ? Json(ranked.folder) : Json(nullptr)},
      {"files", written ? Json(ranking_files(ranked.table.scorecard.name)) : Json::array()},
      {"set_aside", ranked.set_aside.empty() ? Json(nullptr) : Json(ranked.set_aside)},
      {"ranking", Json::parse(ranking_json(ranked.table))}};
  return text_of(json);
}

}  // namespace loosefit::report
