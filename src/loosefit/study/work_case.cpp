#include "loosefit/study/work_case.h"

#include <unistd.h>

#include <chrono>

#include "loosefit/base/error.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/version.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/report/run_into_folder.h"
#include "loosefit/study/controls.h"
#include "loosefit/study/measure_case.h"

namespace loosefit::study {
namespace {

pipeline::CaseResult run(const StudyFolder& folder, const std::string& address,
                         const WorkOptions& options, Progress& progress, bool to_grade_a = false) {
  scenario::Scenario scenario = io::read_scenario(folder.scenario_file(address).string());
  scenario.file = "scenario.toml";  // in messages, which are the same wherever the study lies
  scenario.simulation.threads = options.threads;
  if (to_grade_a) scenario.simulation.certificate = solver::RestGrade::a;
  if (!options.keep_output || to_grade_a) return pipeline::run_case(scenario, progress);
  return report::run_into_folder(scenario, folder.case_folder(address) / "output", {}, true,
                                 progress)
      .result;
}

CaseRecord failed(const std::string& reason) {
  CaseRecord record;
  record.reason = reason;
  record.grade.clear();
  record.versions = versions();
  return record;
}

/// A control. An error is its result.
CaseRecord to_grade_a(const StudyFolder& folder, const std::string& address,
                      const std::vector<placement::Scorecard>& cards, const WorkOptions& options,
                      Progress& progress) {
  try {
    return measure_case(run(folder, address, options, progress, true), cards);
  } catch (const SolverFailure& error) {
    return failed(error.what());
  }
}

}  // namespace

CaseRecord work_case(const StudyFolder& folder, const std::vector<std::string>& modalities,
                     const std::string& address, const WorkOptions& options, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<placement::Scorecard> cards;
  for (const std::string& modality : modalities) cards.push_back(io::load_scorecard(modality));
  CaseRecord record;
  try {
    const pipeline::CaseResult result = run(folder, address, options, progress);
    const ThreadLimit threads(options.threads);
    record = measure_case(result, cards);
    if (record.status == CaseStatus::done && folder.is_control(address))
      record.control = compared(record, to_grade_a(folder, address, cards, options, progress));
  } catch (const InvalidInput& error) {
    record = failed(error.what());
  } catch (const SolverFailure& error) {
    record = failed(error.what());
  } catch (const std::bad_alloc&) {
    throw IoError("case " + address + ": not enough memory",
                  "fewer workers (--jobs), or a larger simulation.edge_length");
  }
  record.address = address;
  record.execution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.execution.peak_memory_mb = peak_memory_mb();
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  record.execution.host = host;
  write_whole(folder.result_file(address), record_json(record));
  return record;
}

}  // namespace loosefit::study
