#include "loosefit/study/work_case.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>

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

/// An error is the result of the case.
CaseRecord measured(const StudyFolder& folder, const std::string& address,
                    const std::vector<placement::Scorecard>& cards, const WorkOptions& options,
                    Progress& progress, bool to_grade_a = false) {
  try {
    const pipeline::CaseResult result = run(folder, address, options, progress, to_grade_a);
    const ThreadLimit threads(options.threads);
    return measure_case(result, cards);
  } catch (const InvalidInput& error) {
    return failed(error.what());
  } catch (const SolverFailure& error) {
    return failed(error.what());
  } catch (const std::bad_alloc&) {
    throw IoError("case " + address + ": not enough memory",
                  "fewer workers (--jobs), or a larger simulation.edge_length");
  } catch (const IoError&) {
    throw;  // of the machine, not of the case, which is to run again
  } catch (const std::system_error&) {
    throw;  // likewise
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    // Nothing that a case brings with it may keep the others from running.
    return failed(std::string("an unexpected error of the program: ") + error.what());
  }
}

/// What this process has taken since `start`, on top of what processes before it have.
void add_execution(std::chrono::steady_clock::time_point start, Execution& execution) {
  execution.seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.peak_memory_mb = std::max(execution.peak_memory_mb, peak_memory_mb());
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  execution.host = host;
}

}  // namespace

CaseRecord work_case(const StudyFolder& folder, const FolderPlan& plan, const std::string& address,
                     const WorkOptions& options, Progress& progress) {
  std::vector<placement::Scorecard> cards;
  for (const std::string& modality : plan.modalities) cards.push_back(io::load_scorecard(modality));
  const auto write = [&](const CaseRecord& record) {
    write_whole(folder.result_file(address), record_json(record));
  };
  CaseRecord record;
  // Grade A is compared with grade B of the same build: else a change of the program would be told
  // as one of the grade.
  const auto before = folder.record(address);
  const bool wants_control = before && plan.controls.count(address) &&
                             before->status == CaseStatus::done && !before->control.ran;
  if (before && !(wants_control && of_another_build(*before))) {
    record = *before;
  } else {
    const auto start = std::chrono::steady_clock::now();
    record = measured(folder, address, cards, options, progress);
    record.address = address;
    add_execution(start, record.execution);
    write(record);  // also of a control: whatever ends it, this stays
  }
  if (record.status == CaseStatus::done && plan.controls.count(address) && !record.control.ran) {
    const auto start = std::chrono::steady_clock::now();
    record.control = compared(record, measured(folder, address, cards, options, progress, true));
    add_execution(start, record.execution);
    write(record);
  }
  return record;
}

}  // namespace loosefit::study
