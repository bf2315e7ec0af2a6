#include "loosefit/io/replace_files.h"

#include <algorithm>
#include <functional>

#include "loosefit/base/text.h"
#include "loosefit/io/plain_files.h"
#include "loosefit/io/staging_folder.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

std::string first_names(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 6;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i)
    shown.push_back(printable(names[i]));
  return join(shown) + (names.size() > kShown
                            ? " and " + std::to_string(names.size() - kShown) + " more"
                            : std::string());
}

fs::path backup_of(const std::string& file, const fs::path& target, const PendingCommit& pending) {
  return pending.aside.count(file) ? target / pending.aside_folder / file
                                   : target / pending.staging / "old" / file;
}

void make_parents(const fs::path& folder, const std::string& file) {
  fs::path at = folder;
  for (const auto& part : fs::path(file).parent_path()) make_folder(at /= part);
}

/// The commit and the mark that holds after it.
struct Plan {
  PendingCommit commit;
  OutputMark after;
};

/// Whether a folder of ours will be empty: all that is in it goes, and nothing comes.
bool becomes_empty(const fs::path& target, const std::string& folder, const OutputMark& before,
                   const PendingCommit& commit) {
  if (standing(target, folder) != Standing::folder) return false;
  for (const auto& [file, digest] : commit.incoming)
    if (file.rfind(folder + "/", 0) == 0) return false;
  std::error_code error;
  for (fs::directory_iterator entry(target / folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = folder + "/" + entry->path().filename().string();
    if (!commit.outgoing.count(name) &&
        !(before.folders.count(name) && becomes_empty(target, name, before, commit)))
      return false;
  }
  return !error;
}

/// The first of replaced-1, replaced-2, … that is free.
std::string free_aside_folder(const fs::path& target) {
  for (int k = 1;; ++k)
    if (const std::string name = "replaced-" + std::to_string(k);
        standing(target, name) == Standing::nothing)
      return name;
}

/// What to do with one new file. Returns whether something is in the way.
bool add_file(const Replacement& wish, const OutputMark& before, const std::string& file,
              Plan& plan) {
  const std::string coming = *plain_digest(wish.incoming, file);
  const Standing there = standing(wish.target, file);
  const auto found = plain_digest(wish.target, file);
  const std::string* known = before.digest(file);
  const bool ours = found && known && *found == *known;
  if (found && *found == coming && !ours) {  // somebody else's, and already as it should be
    plan.after.forget(file);
    return false;
  }
  if (there != Standing::nothing && !ours) {
    plan.after.forget(file);
    if (wish.leave_edited.count(file)) return false;
    if (!wish.set_aside || known || there != Standing::plain_file) return true;
    plan.commit.aside.insert(file);
  }
  plan.after.forget(file);
  plan.after.sets[wish.kind][file] = coming;
  if (ours && *found == coming) return false;
  if (there != Standing::nothing) plan.commit.outgoing.insert(file);
  plan.commit.incoming[file] = coming;
  return false;
}

Plan plan_of(const Replacement& wish, const OutputMark& before, const std::string& staging) {
  Plan plan;
  plan.after = before;
  plan.commit.kind = wish.kind;
  plan.commit.staging = staging;
  plan.after.adopted = wish.set_aside;
  plan.after.sets[wish.kind];
  if (wish.whole) {
    plan.after.sets[wish.kind].clear();
    plan.after.name_anew(wish.kind);
  }
  std::vector<std::string> blocked;
  std::vector<std::string> files = plain_files(wish.incoming);
  std::erase(files, kOutputMark);  // of a folder that was to be a new one
  for (const std::string& file : files)
    if (add_file(wish, before, file, plan)) blocked.push_back(file);
  if (!blocked.empty()) throw FilesInTheWay(wish.target, blocked);
  if (const auto earlier = before.sets.find(wish.kind); wish.whole && earlier != before.sets.end())
    for (const auto& [file, digest] : earlier->second)
      if (!std::binary_search(files.begin(), files.end(), file) &&
          plain_digest(wish.target, file) == digest)
        plan.commit.outgoing.insert(file);
  if (!plan.commit.aside.empty()) plan.commit.aside_folder = free_aside_folder(wish.target);

  std::set<std::string> coming;
  for (const auto& [file, digest] : plan.commit.incoming) coming.insert(file);
  plan.commit.made = missing_folders(wish.target, coming);
  for (const std::string& folder : before.folders)
    if (becomes_empty(wish.target, folder, before, plan.commit))
      plan.commit.removed.push_back(folder);
  std::reverse(plan.commit.removed.begin(), plan.commit.removed.end());
  plan.after.folders.insert(plan.commit.made.begin(), plan.commit.made.end());
  for (const std::string& folder : plan.commit.removed) plan.after.folders.erase(folder);
  return plan;
}

void write_synced(const fs::path& file, const std::string& text) {
  write_text_file(file.string(), text);
  sync_to_disk(file);
}

/// Step 1 but for the new files, which are there.
void prepare(const Replacement& wish, const std::optional<OutputMark>& before, Plan& plan) {
  const fs::path staging = wish.target / plan.commit.staging;
  for (const auto& [file, digest] : plan.commit.incoming) sync_to_disk(wish.incoming / file);
  for (const std::string& file : plan.commit.outgoing)
    if (!plan.commit.aside.count(file)) make_parents(staging / "old", file);
  OutputMark pending = before.value_or(OutputMark());
  plan.commit.first = !before;
  pending.pending = plan.commit;
  if (before) write_synced(staging / "mark-before", before->text());
  write_synced(staging / "mark-after", plan.after.text());
  write_synced(staging / "mark-pending", pending.text());
  sync_to_disk(staging);
}

/// Step 3.
void move_all(const fs::path& target, const PendingCommit& commit) {
  for (const std::string& file : commit.outgoing) {
    if (commit.aside.count(file)) {
      make_folder(target / commit.aside_folder);
      make_parents(target / commit.aside_folder, file);
    }
    move_to_free_name(target / file, backup_of(file, target, commit));
  }
  for (const auto& [file, digest] : commit.incoming) {
    make_parents(target, file);
    const fs::path from = target / commit.staging / "new" / file;
    try {
      move_to_free_name(from, target / file);
    } catch (const IoError&) {
      if (is_there(from) && is_there(target / file)) throw FilesInTheWay(target, {file});
      throw;
    }
  }
  for (const std::string& folder : commit.removed) remove_if_empty(target, folder);
  for (const std::string& folder : commit.made) sync_to_disk(target / folder);
  sync_to_disk(target);
}

/// Old files were looked at before the new ones were on the disk: who saved one since keeps it.
void check_taken_files(const fs::path& target, const PendingCommit& commit,
                       const OutputMark& before) {
  std::vector<std::string> changed;
  for (const std::string& file : commit.outgoing) {
    const std::string* known = before.digest(file);
    if (commit.aside.count(file) || !known) continue;  // what is set aside stays in any case
    if (plain_digest(target / commit.staging / "old", file) != *known) changed.push_back(file);
  }
  if (!changed.empty()) throw FilesInTheWay(target, changed);
}

/// Files set aside leave empty folders behind when they move back.
void remove_aside_folder(const fs::path& target, const PendingCommit& pending) {
  for (const std::string& file : pending.aside)
    for (fs::path up = fs::path(file).parent_path(); !up.empty(); up = up.parent_path())
      remove_if_empty(target / pending.aside_folder, up.generic_string());
  remove_if_empty(target, pending.aside_folder);
}

/// Steps 3 and 2 backwards; may be carried out again after it was cut short.
void move_back(const fs::path& target, const PendingCommit& pending) {
  const fs::path staging = target / pending.staging;
  for (const auto& [file, digest] : pending.incoming) {
    const bool replaces = pending.outgoing.count(file) > 0;
    const fs::path backup = backup_of(file, target, pending);
    if (replaces && !is_there(backup)) continue;         // still the old one
    if (plain_digest(target, file) != digest) continue;  // not come yet, or changed since
    make_parents(staging / "new", file);
    move_to_free_name(target / file, staging / "new" / file);
  }
  for (auto folder = pending.made.rbegin(); folder != pending.made.rend(); ++folder)
    remove_if_empty(target, *folder);
  for (const std::string& file : pending.outgoing) {
    const fs::path backup = backup_of(file, target, pending);
    // Whatever took the place meanwhile stays; what was set aside stays there then.
    if (!is_there(backup) || standing(target, file) != Standing::nothing) continue;
    make_parents(target, file);
    move_to_free_name(backup, target / file);
  }
  if (!pending.aside.empty()) remove_aside_folder(target, pending);
  sync_to_disk(target);
  if (pending.first) {
    std::error_code error;
    fs::remove(target / kOutputMark, error);
    if (error) throw IoError((target / kOutputMark).string() + ": " + error.message());
  } else {
    move_over(staging / "mark-before", target / kOutputMark);
  }
  sync_to_disk(target);
}

}  // namespace

FilesInTheWay::FilesInTheWay(const fs::path& folder, const std::vector<std::string>& names)
    : InvalidInput({folder.string(), 0, first_names(names)},
                   names.size() == 1 ? "a file that Loosefit did not write, or that was changed"
                                     : "files that Loosefit did not write, or that were changed",
                   "only files as Loosefit wrote them where new ones go",
                   "nothing was changed; move them away, or write into another folder") {}

MadeMeanwhile::MadeMeanwhile(const fs::path& folder)
    : InvalidInput({folder.string(), 0, ""}, "the output of another run, made meanwhile",
                   "what was there when this work began", "nothing was changed; run it again") {}

std::vector<std::string> in_the_way(const fs::path& folder, const OutputMark& mark,
                                    const std::vector<std::string>& planned) {
  std::vector<std::string> names;
  for (const std::string& file : planned) {
    if (standing(folder, file) == Standing::nothing) continue;
    const auto found = plain_digest(folder, file);
    const std::string* known = mark.digest(file);
    if (!found || !known || *found != *known) names.push_back(file);
  }
  return names;
}

std::string replace_files(const Replacement& wish, const std::string& staging) {
  const fs::path hidden = wish.target / staging;
  const fs::path mark = wish.target / kOutputMark;
  const FileLock lock(wish.target, true, true);
  const std::optional<OutputMark> before = read_output_mark(wish.target);
  if (before && before->pending)
    throw IoError(wish.target.string() + ": cannot be written: an earlier commit is not finished",
                  "choose another folder with -o");
  if (wish.found_there && before.value_or(OutputMark()).made != *wish.found_there)
    throw MadeMeanwhile(wish.target);
  Plan plan = plan_of(wish, before.value_or(OutputMark()), staging);
  prepare(wish, before, plan);
  if (before)
    move_over(hidden / "mark-pending", mark);
  else
    move_to_free_name(hidden / "mark-pending", mark);
  try {
    sync_to_disk(wish.target);
    move_all(wish.target, plan.commit);
    check_taken_files(wish.target, plan.commit, before.value_or(OutputMark()));
    move_over(hidden / "mark-after", mark);
  } catch (...) {  // whatever it is: the hidden folder has the only copies of old files
    move_back(wish.target, plan.commit);
    throw;
  }
  return plan.commit.aside_folder;
}

void roll_back(const fs::path& target) {
  if (const auto mark = read_output_mark(target); !mark || !mark->pending) return;
  const FileLock lock(target, true, true);  // whoever is just committing ends first
  const auto mark = read_output_mark(target);
  if (!mark || !mark->pending) return;
  const fs::path staging = target / mark->pending->staging;
  if (!is_there(staging))
    throw IoError(target.string() + ": writing it was interrupted, and the rest, " +
                      staging.lexically_normal().string() + ", is not there",
                  "choose another folder with -o");
  if (!is_abandoned(staging))
    throw IoError(target.string() + ": is being written by another process",
                  "choose another folder with -o, or wait");
  move_back(target, *mark->pending);
  if (!holds_taken_files(staging)) remove_staging(staging);
}

}  // namespace loosefit::io
