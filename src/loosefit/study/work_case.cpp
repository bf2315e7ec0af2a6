#include "loosefit/study/work_case.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "loosefit/base/error.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/version.h"
#include "loosefit/io/replace_files.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/drape_side_by_side.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/report/run_into_folder.h"
#include "loosefit/report/write_output.h"
#include "loosefit/study/measure_case.h"

namespace loosefit::study {
namespace {

/// What is read while a case runs has to be what its address was made of: else its result would
/// stand under the name of another.
void check_inputs(const scenario::Scenario& scenario, const FolderPlan& plan,
                  const std::string& address) {
  if (case_address(scenario, plan.modalities) != address)
    throw IoError("case " + address +
                      ": an input (pattern, scan, body data, scorecard, scenario or program) has "
                      "changed since the plan was made",
                  "run again: the plan is then made anew");
}

/// What the folder of an output refuses is no fault of the case. \throws IoError
void check_output(const scenario::Scenario& scenario, const std::filesystem::path& output) {
  try {
    const io::RunFolder files = io::RunFolder::create(output);
    files.announce(report::planned_files(scenario, {.log = true}));
  } catch (const InvalidInput& error) {
    throw IoError(error.what(), error.hint());
  }
}

pipeline::CaseResult run_keeping(const scenario::Scenario& scenario,
                                 const std::filesystem::path& output, Progress& progress) {
  check_output(scenario, output);
  try {
    return report::run_into_folder(scenario, output, {}, true, progress).result;
  } catch (const io::MadeMeanwhile& error) {
    throw IoError(error.what(), error.hint());
  } catch (const InvalidInput&) {
    check_output(scenario, output);  // something may have come in the way meanwhile
    throw;
  }
}

pipeline::CaseResult run(scenario::Scenario scenario, const std::filesystem::path& output,
                         const WorkOptions& options, Progress& progress) {
  scenario.simulation.threads = options.threads;
  return options.keep_output ? run_keeping(scenario, output, progress)
                             : pipeline::run_case(scenario, progress);
}

[[noreturn]] void refuse_for_memory(const std::string& address) {
  throw IoError("case " + address + ": " + pipeline::kNoMemory,
                "fewer workers (--jobs), or a larger simulation.edge_length");
}

/// Whether a donning or posture is missing that a machine with more memory would have draped.
bool lacked_memory(const pipeline::CaseResult& result) {
  return std::ranges::any_of(result.wear.states, [](const pipeline::CaseState& state) {
    return state.left_out.ends_with(pipeline::kNoMemory);
  });
}

CaseRecord failed(const std::string& reason) {
  CaseRecord record;
  record.reason = reason;
  record.versions = versions();
  return record;
}

/// An error is the result of the case.
CaseRecord measured(const StudyFolder& folder, const std::string& address,
                    const scenario::Scenario& scenario,
                    const std::vector<placement::Scorecard>& cards, const WorkOptions& options,
                    Progress& progress) {
  try {
    const pipeline::CaseResult result =
        run(scenario, folder.case_folder(address) / "output", options, progress);
    if (lacked_memory(result)) refuse_for_memory(address);
    const ThreadLimit threads(options.threads);
    return measure_case(result, cards);
  } catch (const InvalidInput& error) {
    return failed(error.what());
  } catch (const SolverFailure& error) {
    return failed(error.what());
  } catch (const std::bad_alloc&) {
    refuse_for_memory(address);
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

/// What this process has taken since `start`.
Execution execution_since(std::chrono::steady_clock::time_point start) {
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          peak_memory_mb(), host};
}

}  // namespace

CaseRecord work_case(const StudyFolder& folder, const FolderPlan& plan, const std::string& address,
                     const WorkOptions& options, Progress& progress) {
  std::vector<placement::Scorecard> cards;
  for (std::size_t m = 0; m < plan.modalities.size(); ++m) cards.push_back(scorecard(plan, m));
  scenario::Scenario scenario = io::read_scenario(folder.scenario_file(address).string());
  scenario.file = "scenario.toml";  // in messages, which are the same wherever the study lies
  check_inputs(scenario, plan, address);
  if (const auto before = folder.record(address)) return *before;
  const auto start = std::chrono::steady_clock::now();
  CaseRecord record = measured(folder, address, scenario, cards, options, progress);
  record.address = address;
  record.execution = execution_since(start);
  check_inputs(scenario, plan, address);
  write_whole(folder.result_file(address), record_json(record));
  return record;
}

}  // namespace loosefit::study
