#include "loosefit/study/run_on_slurm.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/plain_files.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/worker_process.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

/// Slurm's usual MaxArraySize is 1001: the greatest index is 1000.
constexpr int kMostTasks = 1000;
constexpr int kRoundsWithoutResult = 3;
constexpr int kPause = 500000;  ///< between two questions [µs]
constexpr std::size_t kLargestBundles = 500000000;
constexpr int kSilence = 20;  ///< times in a row that squeue may fail to answer

std::string tool(const std::string& name) {
  for (const char* folder : {"/usr/bin/", "/usr/local/bin/", "/opt/slurm/bin/"})
    if (access((folder + name).c_str(), X_OK) == 0) return folder + name;
  throw IoError(name + ": found no such program, expected Slurm's",
                "install slurm-client, or run with --executor local");
}

/// In single quotes for the shell.
std::string quoted(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

class SlurmArrays {
 public:
  SlurmArrays(const StudyFolder& folder, const RunnerOptions& options, const ResultSeen& seen,
              Progress& progress)
      : folder_(folder), options_(options), seen_(seen), progress_(progress) {
    std::error_code error;
    fs::create_directories(place(), error);
    if (error) throw IoError(place().string() + ": cannot be made: " + error.message());
  }

  std::vector<GivenUp> run(const std::vector<std::string>& addresses) {
    open_.assign(addresses.begin(), addresses.end());
    take_up_earlier_job();
    int idle = 0;
    while (!open_.empty() && idle < kRoundsWithoutResult) {
      const std::size_t before = open_.size();
      submit();
      wait();
      idle = open_.size() < before ? 0 : idle + 1;
    }
    std::vector<GivenUp> given_up;
    for (const std::string& address : open_)
      given_up.push_back({address, "its array tasks ended without a result; their output is in " +
                                       place().string()});
    return given_up;
  }

 private:
  fs::path place() const { return folder_.path() / "slurm"; }
  fs::path job_file() const { return place() / "job"; }

  void take_up_earlier_job() {
    std::error_code error;
    if (!fs::exists(job_file(), error)) return;
    job_ = io::read_text_file(job_file().string(), 1000);
    if (is_queued()) wait();
  }

  /// As many open cases as one array holds.
  void submit() {
    const int bundle = std::max(1, options_.bundle);
    std::string lines;
    int tasks = 0;
    for (std::size_t i = 0; i < open_.size() && tasks < kMostTasks; ++tasks) {
      for (int k = 0; k < bundle && i < open_.size(); ++k, ++i)
        lines += (k > 0 ? " " : "") + open_[i];
      lines += "\n";
    }
    int round = 1;
    while (io::is_there(place() / fmt::format("bundles-{}.txt", round))) ++round;
    const fs::path bundles = fs::absolute(place() / fmt::format("bundles-{}.txt", round));
    write_whole(bundles, lines);
    std::string script = "#!/bin/sh\n";
    script += fmt::format("exec {} study bundle {} {} \"$SLURM_ARRAY_TASK_ID\" --threads {}{}\n",
                          quoted(options_.program), quoted(fs::absolute(folder_.path()).string()),
                          quoted(bundles.string()), options_.threads,
                          options_.keep_output ? " --keep-output" : "");
    const fs::path file = place() / fmt::format("task-{}.sh", round);
    write_whole(file, script);
    std::vector<std::string> command = {
        tool("sbatch"),
        "--parsable",
        "--job-name=loosefit-study",
        "--no-requeue",
        fmt::format("--cpus-per-task={}", std::max(1, options_.threads)),
        fmt::format("--array=0-{}", tasks - 1),
        "--chdir=" + fs::absolute(place()).string(),
        "--output=" + fs::absolute(place()).string() + "/%A-%a.out"};
    if (!options_.partition.empty()) command.push_back("--partition=" + options_.partition);
    if (!options_.time_limit.empty()) command.push_back("--time=" + options_.time_limit);
    if (options_.memory_mb > 0) command.push_back(fmt::format("--mem={}", options_.memory_mb));
    command.push_back(file.string());
    const ProcessEnd end = run_to_end(command);
    job_ = end.output.substr(0, end.output.find_first_of(";\n"));
    if (end.signal != 0 || end.exit_code != 0 || job_.empty() ||
        job_.find_first_not_of("0123456789") != std::string::npos)
      throw IoError("sbatch: " + terminal_line(end.output), "look at partition and time limit");
    write_whole(job_file(), job_);
  }

  bool is_queued() {
    const ProcessEnd end = run_to_end({tool("squeue"), "-h", "-j", job_, "-o", "%i %T"});
    if (end.signal == 0 && end.exit_code == 0) {
      silence_ = 0;
      return !end.output.empty();
    }
    // A job that has ended is forgotten after a while, and is then an error.
    if (end.output.find("Invalid job id") != std::string::npos) return false;
    if (++silence_ >= kSilence) throw IoError("squeue: " + terminal_line(end.output));
    return true;
  }

  void wait() {
    try {
      while (true) {
        progress_.check_cancelled();
        const bool queued = is_queued();  // before the results: what ends now is seen below
        look();
        if (!queued) break;
        usleep(kPause);
      }
    } catch (const Cancelled&) {
      run_to_end({tool("scancel"), job_});
      throw;
    }
    std::error_code error;
    fs::remove(job_file(), error);
  }

  void look() {
    std::erase_if(open_, [&](const std::string& address) {
      const auto record = folder_.record(address);
      if (record) seen_(*record);
      return record.has_value();
    });
  }

  const StudyFolder& folder_;
  const RunnerOptions& options_;
  const ResultSeen& seen_;
  Progress& progress_;
  std::vector<std::string> open_;
  std::string job_;
  int silence_ = 0;
};

}  // namespace

std::vector<GivenUp> run_on_slurm(const StudyFolder& folder,
                                  const std::vector<std::string>& addresses,
                                  const RunnerOptions& options, const ResultSeen& seen,
                                  Progress& progress) {
  return SlurmArrays(folder, options, seen, progress).run(addresses);
}

std::vector<std::string> read_bundle(const std::string& file, int index) {
  std::istringstream lines(io::read_text_file(file, kLargestBundles));
  std::string line;
  for (int i = 0; i <= index; ++i)
    if (!std::getline(lines, line))
      throw InvalidInput({file, 0, ""}, "no line " + std::to_string(index), "a bundle of cases");
  std::istringstream words(line);
  std::vector<std::string> addresses;
  for (std::string word; words >> word;) addresses.push_back(word);
  return addresses;
}

}  // namespace loosefit::study
