#include "loosefit/io/staging_folder.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/io/output_mark.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

constexpr const char* kWriting = ".loosefit-writing";
constexpr const char* kFirstWord = "loosefit-writing";

/// A process: its number, which is used again, with the time of its start [ticks since boot].
struct Process {
  long number = 0;
  unsigned long long start = 0;
};

/// Start of a process; nothing when it is gone or ended.
std::optional<unsigned long long> start_of(long number) {
  std::ifstream file("/proc/" + std::to_string(number) + "/stat");
  std::string line;
  if (!std::getline(file, line)) return {};
  const std::size_t name_end = line.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  std::string word;
  rest >> word;
  if (word == "Z" || word == "X") return {};
  for (int field = 4; field <= 21; ++field) rest >> word;
  unsigned long long start = 0;
  if (!(rest >> start)) return {};
  return start;
}

std::string prefix_of(const fs::path& target) {
  return "." + target.filename().string() + ".writing-";
}

/// Number of the process in the name of a hidden folder of this output: 7 of ".out.writing-7-2".
std::optional<long> number_in(const std::string& name, const fs::path& target) {
  const std::string prefix = prefix_of(target);
  if (name.rfind(prefix, 0) != 0) return {};
  const std::string rest = name.substr(prefix.size());
  if (rest.empty() || rest.size() > 18 || rest[0] == '-' ||
      rest.find_first_not_of("0123456789-") != std::string::npos)
    return {};
  return std::stol(rest);
}

std::optional<Process> owner_of(const fs::path& staging) {
  if (standing(staging, kWriting) != Standing::plain_file) return {};
  std::ifstream file(staging / kWriting);
  std::string word;
  Process process;
  if (!(file >> word) || word != kFirstWord || !(file >> process.number >> process.start))
    return {};
  return process;
}

bool is_gone(long number, std::optional<unsigned long long> start) {
  if (kill(static_cast<pid_t>(number), 0) != 0 && errno == ESRCH) return true;
  return start && *start != 0 && start_of(number) != *start && start_of(getpid());
}

bool holds_old_files(const fs::path& staging) {
  if (standing(staging, "old") != Standing::folder) return false;
  try {
    return !plain_files(staging / "old").empty();
  } catch (const IoError&) {
    return true;
  }
}

std::vector<fs::path> hidden_folders(const fs::path& place, const fs::path& target) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end;
       entry.increment(error))
    if (number_in(entry->path().filename().string(), target) &&
        standing(place, entry->path().filename().string()) == Standing::folder)
      found.push_back(entry->path());
  return found;
}

/// Whether a process was killed while it began: nothing in the folder, or the file of its process,
/// of which nothing is written. Not where others alone may look.
bool is_unbegun(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename() != kWriting || !fs::is_empty(entry->path(), error)) return false;
  return !error;
}

/// The first name in `place` that is free; empty when no folder can be made there.
fs::path make_in(const fs::path& place, const fs::path& target, std::error_code& error) {
  const std::string name = prefix_of(target) + std::to_string(getpid());
  for (int k = 1; k < 100; ++k) {
    const fs::path path = place / (k == 1 ? name : name + "-" + std::to_string(k));
    if (fs::create_directory(path, error)) return path;
    if (error) return {};
  }
  error = std::make_error_code(std::errc::file_exists);
  return {};
}

}  // namespace

StagingFolder::StagingFolder(const fs::path& target) : target_(target) {
  std::error_code error;
  const bool there = fs::is_directory(target, error);
  error.clear();
  inside_ = there && !same_mount(target, target.parent_path());
  if (!inside_) path_ = make_in(target.parent_path(), target, error);
  if (path_.empty() && there) {
    inside_ = true;
    path_ = make_in(target, target, error);
  }
  if (path_.empty())
    throw IoError(target.string() + ": cannot be written: " + error.message(),
                  "choose another folder with -o");
  try {
    write_text_file((path_ / kWriting).string(),
                    std::string(kFirstWord) + " " + std::to_string(getpid()) + " " +
                        std::to_string(start_of(getpid()).value_or(0)) + "\n");
    lock_.emplace(path_ / kWriting, false, true);
    make_folder(incoming());
    make_folder(outgoing());
  } catch (const IoError&) {
    remove_staging(path_);
    throw;
  }
}

StagingFolder::~StagingFolder() {
  try {
    if (!path_.empty()) remove_unless_needed();
  } catch (...) {  // it stays: the next process looks again
  }
}

void StagingFolder::remove_unless_needed() const {
  if (holds_taken_files(path_) || commit_is_open()) return;
  remove_staging(path_);
}

bool StagingFolder::commit_is_open() const {
  if (!is_there(path_ / "mark-after")) return false;  // not begun, or done
  try {
    const auto mark = read_output_mark(target_);
    return mark && mark->pending && mark->pending->staging == from_target();
  } catch (const InvalidInput&) {  // something else has the name of the mark
    return false;
  }
}

void StagingFolder::give_away() {
  std::error_code ignored;  // where even this fails, the next process may remove the folder
  fs::remove(path_ / kWriting, ignored);
  path_.clear();
}

std::string StagingFolder::from_target() const {
  return (inside_ ? "" : "../") + path_.filename().string();
}

bool is_abandoned(const fs::path& staging) {
  const auto owner = owner_of(staging);
  if (!owner) return false;
  // Where nothing can be locked, nothing is known of processes on other machines.
  const FileLock lock(staging / kWriting, false, false);
  return lock.holds() && is_gone(owner->number, owner->start);
}

// Only the end of a commit takes this mark away.
bool holds_taken_files(const fs::path& staging) {
  return standing(staging, "mark-after") == Standing::plain_file && holds_old_files(staging);
}

void remove_staging(const fs::path& staging) {
  std::error_code error;
  for (const char* part : {"new", "old", "mark-before", "mark-pending", "mark-after", kWriting}) {
    fs::remove_all(staging / part, error);
    if (error) return;  // the last part is what the next process knows it by
  }
  rmdir(staging.c_str());  // only when nothing else lies in it
}

void clear_left_overs(const fs::path& target) {
  for (const fs::path& place : {target.parent_path(), target})
    for (const fs::path& folder : hidden_folders(place, target)) {
      std::error_code ignored;
      const long number = *number_in(folder.filename().string(), target);
      if (!owner_of(folder) && is_gone(number, {}) && is_unbegun(folder)) {
        fs::remove(folder / kWriting, ignored);
        rmdir(folder.c_str());
        continue;
      }
      if (!holds_taken_files(folder) && is_abandoned(folder)) remove_staging(folder);
    }
}

bool is_empty_output(const fs::path& target) {
  std::error_code error;
  for (fs::directory_iterator entry(target, error), end; !error && entry != end;
       entry.increment(error))
    if (!number_in(entry->path().filename().string(), target) || !owner_of(entry->path()))
      return false;
  if (error) throw IoError(target.string() + ": cannot be read: " + error.message());
  return true;
}

}  // namespace loosefit::io
