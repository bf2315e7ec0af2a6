#include "loosefit/study/run_here.h"

#include <unistd.h>

#include <csignal>
#include <deque>
#include <list>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/resources.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/study/worker_process.h"

namespace loosefit::study {
namespace {

constexpr int kCrashes = 3, kKills = 20;
constexpr int kPause = 10000;        ///< between two looks at the workers [µs]
constexpr int kCancelledCode = 130;  ///< of a worker that was asked to stop

struct Worker {
  std::string address;
  WorkerProcess process;
};

bool from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP ||
         signal == SIGXCPU;
}

std::string last_line(const std::string& text) {
  const std::size_t error = text.rfind("error: ");
  if (error != std::string::npos) {
    const std::string line = text.substr(error + 7);
    return line.substr(0, line.find('\n'));
  }
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? text : text.substr(end + 1);
}

/// The crash as the result of its case.
void record_crash(const StudyFolder& folder, const std::string& address, const std::string& how) {
  CaseRecord record;
  record.address = address;
  record.reason = "the program crashed " + std::to_string(kCrashes) + " times: " + how;
  record.versions = versions();
  write_whole(folder.result_file(address), record_json(record));
}

}  // namespace

std::vector<GivenUp> run_here(const StudyFolder& folder, const std::vector<std::string>& addresses,
                              const RunnerOptions& options, const ResultSeen& seen,
                              Progress& progress) {
  const std::size_t jobs =
      static_cast<std::size_t>(options.jobs > 0 ? options.jobs : usable_threads());
  std::deque<std::string> waiting(addresses.begin(), addresses.end());
  std::map<std::string, int> crashes, kills;
  std::list<Worker> working;
  std::vector<GivenUp> given_up;
  std::string trouble;
  for (const std::string& address : addresses) remove_left_overs(folder.result_file(address));
  while (!working.empty() || (!waiting.empty() && trouble.empty())) {
    progress.check_cancelled();  // workers end with the list
    while (working.size() < jobs && !waiting.empty() && trouble.empty()) {
      std::vector<std::string> command = {options.program,
                                          "study",
                                          "work",
                                          folder.path().string(),
                                          waiting.front(),
                                          "--threads",
                                          std::to_string(options.threads)};
      if (options.keep_output) command.push_back("--keep-output");
      working.push_back({waiting.front(), WorkerProcess(command)});
      waiting.pop_front();
    }
    bool ended = false;
    for (auto worker = working.begin(); worker != working.end();) {
      const std::optional<ProcessEnd> end = worker->process.poll();
      if (!end) {
        ++worker;
        continue;
      }
      ended = true;
      const std::string address = worker->address;
      worker = working.erase(worker);
      if (const auto record = folder.record(address)) {
        // Also of a worker that was killed just after it had written.
        seen(*record);
        continue;
      }
      if (end->signal == 0 && end->exit_code != kCancelledCode) {
        trouble = last_line(end->output);
        if (trouble.empty())
          trouble = "a worker ended with exit code " + std::to_string(end->exit_code);
      } else if (end->signal == 0 || from_outside(end->signal)) {
        const std::string how = end->signal ? signal_name(end->signal) : "a request to stop";
        if (++kills[address] < kKills)
          waiting.push_back(address);
        else
          given_up.push_back({address, "its worker was ended by " + how + " " +
                                           std::to_string(kKills) + " times"});
      } else if (++crashes[address] < kCrashes) {
        waiting.push_back(address);
      } else {
        record_crash(folder, address, signal_name(end->signal));
        seen(*folder.record(address));
      }
    }
    if (!ended) usleep(kPause);
  }
  if (!trouble.empty())
    throw IoError(trouble, "finished cases stay; the same command goes on where it stopped");
  return given_up;
}

}  // namespace loosefit::study
