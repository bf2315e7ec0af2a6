#include "loosefit/io/run_folder.h"

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/io/output_mark.h"
#include "loosefit/io/output_name.h"
#include "loosefit/io/replace_files.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNothingChanged = "nothing was changed; choose another folder with -o";

/// The path without links and "..", as far as it is there, and without a slash at its end.
fs::path real_path(const fs::path& folder) {
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

bool is_plain_file(const fs::path& folder, const std::string& name) {
  return standing(folder, name) == Standing::plain_file;
}

std::vector<fs::path> make_missing(const fs::path& folder) {
  std::vector<fs::path> made;
  for (fs::path up = folder; !up.empty() && !is_there(up); up = up.parent_path())
    made.insert(made.begin(), up);
  for (const fs::path& one : made) {
    std::error_code error;
    fs::create_directory(one, error);
    if (error)
      throw IoError(one.string() + ": cannot make the folder: " + error.message(),
                    "choose another folder with -o");
  }
  return made;
}

/// The same complaint with the hint where the new output is.
[[noreturn]] void refuse(const InvalidInput& why, const std::string& hint) {
  if (dynamic_cast<const MadeMeanwhile*>(&why)) throw MadeMeanwhile(why.what(), hint);
  throw InvalidInput(why.what(), hint);
}

}  // namespace

RunFolder::RunFolder(fs::path target, std::string kind, Mode mode)
    : target_(std::move(target)), kind_(std::move(kind)), mode_(mode) {
  repair_output(target_);
  clear_left_overs(target_);
  check_target();
  parents_ = make_missing(target_.parent_path());
  staging_.emplace(target_);
  if (mode_ != Mode::add) found_ = read_output_mark(target_).value_or(OutputMark()).made;
}

RunFolder::~RunFolder() {
  staging_.reset();
  for (auto one = parents_.rbegin(); one != parents_.rend(); ++one)
    remove_if_empty(one->parent_path(), one->filename().string());
}

RunFolder RunFolder::create(const fs::path& folder, const std::string& kind) {
  check_output_name(folder);
  return {real_path(folder), kind, Mode::whole};
}

RunFolder RunFolder::update(const fs::path& existing, const std::string& kind) {
  check_output_name(existing);
  return {real_path(existing), kind, Mode::update};
}

RunFolder RunFolder::add(const fs::path& folder, const std::string& kind) {
  check_output_name(folder);
  return {real_path(folder), kind, Mode::add};
}

bool RunFolder::has_mark_of_run() const {
  const auto mark = read_output_mark(target_);
  return mark && mark->holds("run");
}

/// In a run of which not every file of ours is known, no file can be told from a foreign one.
bool RunFolder::sets_aside() const {
  if (mode_ != Mode::update) return false;
  const auto mark = read_output_mark(target_);
  return !mark || !mark->holds("run") || mark->adopted;
}

void RunFolder::check_target() const {
  const bool there = is_there(target_);
  std::error_code error;
  const bool folder = there && fs::is_directory(fs::symlink_status(target_, error));
  const bool summary = folder && is_plain_file(target_, "summary.json");
  // A later stage needs the output of an earlier one.
  if (mode_ == Mode::update) {
    if (!folder || (!summary && !has_mark_of_run()))
      throw InvalidInput({target_.string(), 0, ""}, "no earlier output",
                         "a folder written by loosefit run or loosefit drape");
    return;
  }
  // A new folder is always right; a file of that name never.
  if (!there) return;
  const char* const kind = mode_ == Mode::add ? "a folder" : "a new or empty folder";
  if (!folder)
    throw InvalidInput({target_.string(), 0, ""},
                       "something that is not an earlier output, nor a folder", kind,
                       kNothingChanged);
  // Files may be added to a folder, but not to one whose files belong together.
  if (mode_ == Mode::add) {
    if (summary || has_mark_of_run())
      throw InvalidInput({target_.string(), 0, ""},
                         has_mark_of_run()
                             ? "the output of a run, whose files belong together"
                             : "a folder with a summary.json, perhaps of an earlier Loosefit",
                         "another folder", kNothingChanged);
    return;
  }
  // To replace an earlier output, its mark must say what in it Loosefit wrote.
  const auto mark = read_output_mark(target_);
  if ((mark && mark->holds(kind_)) || is_empty_output(target_)) return;
  const std::string file = kind_ == "run" ? "summary.json" : kind_ + ".json";
  throw InvalidInput({target_.string(), 0, ""},
                     is_plain_file(target_, file)
                         ? std::string("a folder without the mark ") + kOutputMark +
                               ", which tells what in it Loosefit wrote: not an earlier output"
                         : "something that is not an earlier output",
                     "a new or empty folder, or an earlier output (" + file + " and its mark)",
                     kNothingChanged);
}

void RunFolder::announce(const std::vector<std::string>& planned) const {
  std::error_code error;
  if (!fs::is_directory(target_, error)) return;
  const auto mark = read_output_mark(target_);
  const OutputMark known = mark.value_or(OutputMark());
  std::vector<std::string> names = in_the_way(target_, known, planned);
  const bool aside = sets_aside();
  std::erase_if(names, [&](const std::string& name) {
    return leave_edited_.count(name) > 0 ||
           (aside && !known.digest(name) && is_plain_file(target_, name));
  });
  if (!names.empty()) throw FilesInTheWay(target_, names);
}

/// The whole hidden folder of new files takes a free name, with a mark of its own.
void RunFolder::become_target(const fs::path& target) {
  OutputMark mark;
  if (mode_ == Mode::whole) mark.name_anew(kind_);
  FileDigests& files = mark.sets[kind_];
  std::set<std::string> names;
  for (const std::string& file : plain_files(path())) {
    if (file == kOutputMark) continue;
    files[file] = *plain_digest(path(), file);
    names.insert(file);
    sync_to_disk(path() / file);
  }
  for (const std::string& name : names)
    for (fs::path up = fs::path(name).parent_path(); !up.empty(); up = up.parent_path())
      mark.folders.insert(up.generic_string());
  write_text_file((path() / kOutputMark).string(), mark.text());
  sync_to_disk(path() / kOutputMark);
  for (const std::string& folder : mark.folders) sync_to_disk(path() / folder);
  sync_to_disk(path());
  move_to_free_name(path(), target);
}

void RunFolder::save_elsewhere(const InvalidInput& why) {
  const auto is_now = [](const fs::path& place) {
    return "nothing in this folder was changed; the new output is " + place.string();
  };
  // In the folder itself where nothing can be moved out of it: a mount point, no permission.
  for (const fs::path& place : {target_.parent_path(), target_}) {
    int k = 1;
    const auto name = [&] { return target_.filename().string() + ".new-" + std::to_string(k); };
    while (is_there(place / name())) ++k;
    try {
      become_target(place / name());
    } catch (const IoError&) {
      continue;
    }
    refuse(why, is_now(place / name()));
  }
  const fs::path left = path();
  staging_->give_away();
  refuse(why, is_now(left) + "; copy it, as it cannot be moved from there");
}

void RunFolder::commit() {
  bool done = false;
  if (!is_there(target_)) {
    try {
      become_target(target_);
      done = true;
    } catch (const IoError&) {
      if (!is_there(target_)) throw;  // else another process was quicker
    }
    if (done) {
      try {
        sync_to_disk(target_.parent_path());
      } catch (const IoError&) {
        staging_->keep();  // a loss of power may bring the hidden folder's new files back
      }
    }
  }
  if (!done) {
    Replacement wish;
    wish.target = target_;
    wish.incoming = path();
    wish.kind = kind_;
    wish.whole = mode_ == Mode::whole;
    wish.leave_edited = leave_edited_;
    wish.found_there = found_;
    try {
      check_target();  // much may have happened since
      wish.set_aside = sets_aside();
      aside_ = replace_files(wish, staging_->from_target());
    } catch (const InvalidInput& error) {
      // Where moving back has failed, the next process needs the files where they are.
      if (mode_ != Mode::whole || staging_->commit_is_open()) throw;
      save_elsewhere(error);
    }
    try {
      sync_to_disk(target_);
    } catch (const IoError&) {
      staging_->keep();  // a loss of power may bring the pending mark back, and that needs it
    }
  }
  staging_.reset();
  parents_.clear();
}

void repair_output(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  try {
    roll_back(real_path(folder));
  } catch (const InvalidInput&) {
    // No mark of ours, so nothing of ours is half replaced; who wants to write will be told.
  }
}

}  // namespace loosefit::io
