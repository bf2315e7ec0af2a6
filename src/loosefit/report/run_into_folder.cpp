#include "loosefit/report/run_into_folder.h"

#include "loosefit/base/text.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/run_log.h"
#include "loosefit/pipeline/load_case.h"
#include "loosefit/report/write_output.h"

namespace loosefit::report {
namespace {

std::string verdict(const drape::Certificate& certificate) {
  if (certificate.holds()) return "settled";
  if (!certificate.settled()) return "not settled";
  return "not worn: " + join(certificate.worn_reasons, "; ");
}

FolderOutput output_of(pipeline::CaseResult result, std::optional<TimedRanking> ranking) {
  FolderOutput output{.result = std::move(result), .ranking = {}, .set_aside = {}};
  if (ranking) output.ranking = std::move(ranking->table);
  return output;
}

}  // namespace

FolderOutput run_into_folder(const scenario::Scenario& scenario,
                             const std::filesystem::path& folder,
                             const pipeline::RunOptions& options, bool pictures,
                             Progress& progress) {
  const OutputParts parts{.log = true,
                          .sites = !options.only_drape,
                          .pictures = pictures && !options.only_drape,
                          .report = !options.only_drape};
  io::RunFolder files = io::RunFolder::create(folder);
  files.announce(planned_files(scenario, parts));
  io::RunLog log(files.path() / "log.jsonl", progress);

  pipeline::CaseResult result = pipeline::run_case(scenario, log, options);
  std::optional<TimedRanking> ranking = rank_as_asked(result, log);
  result = write_output(files.path(), std::move(result), parts, ranking, log);

  for (const std::string& warning : result.warnings) log.warning(warning);
  log.end(verdict(result.certificate()));
  files.commit();
  return output_of(std::move(result), std::move(ranking));
}

FolderOutput redo_in_folder(const std::filesystem::path& folder, const RedoOptions& options,
                            Progress& progress) {
  const OutputParts parts{.pictures = options.pictures, .report = options.report};
  io::RunFolder files = io::RunFolder::update(folder);
  files.leave_if_edited("scenario.toml");

  pipeline::CaseResult result = pipeline::load_case(folder, progress);
  if (!options.maps.empty()) result.scenario.output.maps = options.maps;
  files.announce(planned_files(result.scenario, parts));
  result = pipeline::remap_case(std::move(result), options.allow_unsettled, progress);
  std::optional<TimedRanking> ranking = rank_as_asked(result, progress);
  if (!parts.report) ranking.reset();  // the files of an earlier ranking stay
  result = write_output(files.path(), std::move(result), parts, ranking, progress);

  files.commit();
  FolderOutput output = output_of(std::move(result), std::move(ranking));
  output.set_aside = files.aside();
  return output;
}

}  // namespace loosefit::report
