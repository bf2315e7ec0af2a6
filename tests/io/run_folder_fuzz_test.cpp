#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <filesystem>
#include <map>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/io/output_mark.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/text_file.h"
#include "support/file_faults.h"
#include "support/scratch_folder.h"

// Random folders with and without our files, then a write that goes through, is given up, refused,
// meets a full or failing disk, or is killed at any of its changes to the file system: nothing
// foreign is ever another, and our files are all the old or all the new ones.
namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

/// What stands at a name: content of a file with its inode, or where a link leads.
struct Entry {
  char type = '?';
  std::string content;
  ino_t inode = 0;
  bool operator==(const Entry& other) const {
    return type == other.type && content == other.content && inode == other.inode;
  }
};
using Tree = std::map<std::string, Entry>;

Tree tree_of(const fs::path& base) {
  Tree tree;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(base)) {
    struct stat found;
    if (lstat(entry.path().c_str(), &found) != 0) continue;
    Entry& one = tree[entry.path().lexically_relative(base).string()];
    if (S_ISLNK(found.st_mode)) {
      one = {'l', fs::read_symlink(entry.path()).string(), found.st_ino};
    } else if (S_ISDIR(found.st_mode)) {
      one = {'d', "", 0};  // a folder of ours may be made again
    } else {
      // Our mark may be written again with the same content.
      const bool mark = entry.path().filename() == kOutputMark;
      one = {'f', read_text_file(entry.path().string(), 1000000), mark ? 0 : found.st_ino};
    }
  }
  return tree;
}

std::string difference(const Tree& before, const Tree& after) {
  std::string text;
  for (const auto& [name, entry] : before)
    if (const auto found = after.find(name); found == after.end())
      text += "gone: " + name + "\n";
    else if (!(found->second == entry))
      text += "changed: " + name + " " + entry.content + " -> " + found->second.content + "\n";
  for (const auto& [name, entry] : after)
    if (!before.count(name)) text += "new: " + name + "\n";
  return text;
}

using Files = std::map<std::string, std::string>;

const std::vector<std::string> kNames = {"summary.json",
                                         "drape.vtp",
                                         "report.html",
                                         "scenario.toml",
                                         "maps/strain-front.png",
                                         "maps/drape-back.png",
                                         "postures/arms up/drape.vtp",
                                         "donnings/2/reference/drape.vtp",
                                         "ranking-ecg.csv",
                                         "50 %\xff.json"};

enum class Way { create, update, add };

/// One case: a folder, what is in it, and what is done to it.
struct Case {
  std::mt19937 random;
  fs::path base, out;
  Way way;
  Files old;  ///< files of the earlier output that nobody has touched

  Case(unsigned seed, const fs::path& folder) : random(seed), base(folder), out(base / "out") {
    way = static_cast<Way>(std::min(draw(5), 2));
  }
  int draw(int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }
  bool chance(int percent) { return draw(100) < percent; }

  Files draw_files() {
    Files files = {{"log.jsonl", "log"}};
    for (const std::string& name : kNames)
      if (chance(50)) files[name] = std::string(1 + draw(400), static_cast<char>('a' + draw(26)));
    if (way == Way::add)
      files.erase("summary.json");  // by which a folder is that of a run, which `add` refuses
    else if (chance(80))
      files["summary.json"] = "{" + std::to_string(draw(1000)) + "}";
    return files;
  }

  void put(const std::string& name, const std::string& text) {
    std::error_code in_the_way;
    fs::create_directories((base / name).parent_path(), in_the_way);
    if (!in_the_way && !fs::exists(fs::symlink_status(base / name)))
      write_text_file((base / name).string(), text);
  }

  void make_world() {
    fs::create_directories(base / "elsewhere/maps");
    put("elsewhere/thesis.tex", "dear");
    put("elsewhere/maps/strain-front.png", "theirs");
    if (chance(10)) put(".out.writing-1/precious", "not a hidden folder of ours");
    if (chance(10)) put(".out.writing-999999/new/precious", "nor this");
    if (chance(10)) return;  // no folder at all
    if (chance(15)) {
      fs::create_directories(base / "elsewhere/real");
      fs::create_directory_symlink("elsewhere/real", out);
    } else {
      fs::create_directory(out);
    }
    if (chance(85)) make_earlier_output();
    meddle();
  }

  void make_earlier_output() {
    old = draw_files();
    if (way != Way::add) old["summary.json"] = "{}";
    RunFolder folder = way == Way::add ? RunFolder::add(out, "body") : RunFolder::create(out);
    write(folder.path(), old);
    folder.commit();
  }

  static void write(const fs::path& folder, const Files& files) {
    for (const auto& [name, text] : files) {
      fs::create_directories((folder / name).parent_path());
      write_text_file((folder / name).string(), text);
    }
  }

  /// What people do to a folder.
  void meddle() {
    while (chance(45)) put("out/notes-" + std::to_string(draw(9)) + ".txt", "mine");
    if (chance(20)) put("out/maps/mine.png", "mine");
    if (chance(20)) put("out/postures/arms up/mine/a.txt", "mine");
    if (chance(7)) put("out/" + kNames[draw(10)], "mine");
    if (chance(10)) folder("donnings/empty");
    if (chance(4)) folder(kNames[draw(10)]);
    if (chance(5)) link("thesis.tex", kNames[draw(10)]);
    if (chance(4)) link("nowhere", kNames[draw(10)]);
    if (chance(10)) link("thesis.tex", "a-link");
    if (chance(5)) replace_folder_by_link("maps");
    if (chance(8)) change(kNames[draw(10)], "edited");
    if (chance(15)) change(kNames[draw(10)], "");
    if (chance(10)) {
      fs::remove(out / kOutputMark);
      old.clear();
      if (chance(30)) put(std::string("out/") + kOutputMark, "{\"format\": \"other\"}");
    }
  }

  void folder(const std::string& name) {
    std::error_code in_the_way;
    fs::create_directories(out / name, in_the_way);
  }

  void link(const std::string& to, const std::string& name) {
    std::error_code in_the_way;
    fs::create_directories((out / name).parent_path(), in_the_way);
    if (old.count(name)) fs::remove(out / name, in_the_way);
    fs::create_symlink(base / "elsewhere" / to, out / name, in_the_way);
    old.erase(name);
  }

  void replace_folder_by_link(const std::string& name) {
    const bool moves = fs::is_directory(fs::symlink_status(out / name));
    if (moves)
      fs::rename(out / name, base / "elsewhere/moved");
    else if (fs::exists(fs::symlink_status(out / name)))
      return;
    // Behind the link there may be what we wrote: it is theirs all the same.
    fs::create_directory_symlink(base / "elsewhere" / (moves ? "moved" : "maps"), out / name);
    std::erase_if(old, [&](const auto& file) { return file.first.rfind(name + "/", 0) == 0; });
  }

  /// Edits a file of ours, or removes it when there is no text.
  void change(const std::string& name, const std::string& text) {
    if (!old.count(name) || fs::is_symlink(out / name)) return;
    fs::remove(out / name);
    if (!text.empty()) write_text_file((out / name).string(), text);
    old.erase(name);
  }
};

struct Ending {
  bool killed = false;
  int code = 0;  ///< 0 committed, 1 refused, 2 failed, 3 given up
};

enum class Trouble { none, gives_up, fault, full_disk };

/// Exit code of the write, in this process.
int write_files(const fs::path& out, const Files& files, Way way, bool announces, bool gives_up) {
  try {
    RunFolder folder = way == Way::create   ? RunFolder::create(out)
                       : way == Way::update ? RunFolder::update(out)
                                            : RunFolder::add(out, "body");
    if (way == Way::update) folder.leave_if_edited("scenario.toml");
    std::vector<std::string> planned;
    for (const auto& [name, text] : files) planned.push_back(name);
    if (announces) folder.announce(planned);
    Case::write(folder.path(), files);
    if (gives_up) throw Cancelled();
    folder.commit();
    return 0;
  } catch (const InvalidInput&) {
    return 1;
  } catch (const Cancelled&) {
    return 3;
  } catch (const std::exception&) {  // IoError, and what std::filesystem throws in write()
    return 2;
  }
}

/// The same in a process of its own, with trouble.
Ending write_in_child(const Case& c, const Files& files, Way way, bool announces, Trouble trouble,
                      const faults::Plan& plan, rlim_t limit) {
  const pid_t child = fork();
  if (child == 0) {
    if (trouble == Trouble::full_disk) {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit full = {limit, limit};
      setrlimit(RLIMIT_FSIZE, &full);
    }
    if (trouble == Trouble::fault) faults::plan = plan;
    _exit(write_files(c.out, files, way, announces, trouble == Trouble::gives_up || files.empty()));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFSIGNALED(status), WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

/// Everything that was there before and is not ours.
void expect_foreign_untouched(const Case& c, const Tree& before, const Tree& now,
                              const Files& files, bool set_aside) {
  for (const auto& [name, entry] : before) {
    const bool in_link = fs::is_symlink(c.out);
    const std::string real = in_link ? "elsewhere/real/" : "out/";
    const bool below = name.rfind(real, 0) == 0;
    const std::string inner = below ? name.substr(real.size()) : "";
    if (below && (c.old.count(inner) || inner == kOutputMark || entry.type == 'd')) continue;
    const auto found = now.find(name);
    if (set_aside && files.count(inner) && (found == now.end() || !(found->second == entry))) {
      const auto aside = now.find(real + "replaced-1/" + inner);
      EXPECT_TRUE(aside != now.end() && aside->second == entry) << "lost: " << name;
      continue;
    }
    EXPECT_TRUE(found != now.end() && found->second == entry) << "not as it was: " << name;
  }
}

/// All new: what came is there, what went with it is gone, and nothing else has come.
void expect_all_new(const Case& c, const Tree& before, const Tree& now, const Files& files,
                    Way way) {
  const std::string real = fs::is_symlink(c.out) ? "elsewhere/real/" : "out/";
  for (const auto& [name, text] : files) {
    const auto found = now.find(real + name);
    if (way == Way::update && name == "scenario.toml" && before.count(real + name) &&
        !c.old.count(name))
      continue;  // edited, and left
    EXPECT_TRUE(found != now.end() && found->second.content == text) << name;
  }
  for (const auto& [name, text] : c.old)
    if (!files.count(name)) {
      EXPECT_EQ(now.count(real + name), way == Way::create ? 0u : 1u) << name;
    }
  EXPECT_TRUE(now.count(real + kOutputMark));
  for (const auto& [name, entry] : now) {
    if (before.count(name) || name == "out" || name == real + kOutputMark) continue;
    if (name.rfind(real + "replaced-1", 0) == 0) continue;
    bool wanted = false;
    for (const auto& [file, text] : files)
      wanted = wanted || name == real + file || (real + file).rfind(name + "/", 0) == 0;
    EXPECT_TRUE(wanted) << "came from nowhere: " << name;
  }
}

/// Which of the two the folder is now; both are checked in full.
void expect_old_or_new(const Case& c, const Tree& before, const Files& files, Way way,
                       bool set_aside) {
  const Tree now = tree_of(c.base);
  expect_foreign_untouched(c, before, now, files, set_aside);
  if (difference(before, now).empty()) return;
  expect_all_new(c, before, now, files, way);
  if (::testing::Test::HasFailure()) std::fputs(difference(before, now).c_str(), stderr);
}

/// An output that met foreign files at the last moment goes beside the folder, as a whole.
void check_saved_elsewhere(const Case& c, const Files& files) {
  for (const char* name : {"out.new-1", "elsewhere/real.new-1"}) {
    if (!fs::exists(c.base / name)) continue;
    EXPECT_EQ(c.way, Way::create);
    for (const auto& [file, text] : files)
      EXPECT_EQ(read_text_file((c.base / name / file).string(), 1000), text) << file;
    fs::remove_all(c.base / name);
  }
  // Or, where even that fails, stays in the hidden folder, which is then nobody's.
  for (const fs::path& place : {c.base, c.base / "elsewhere"})
    for (const fs::directory_entry& entry : fs::directory_iterator(place)) {
      const fs::path left = entry.path() / "new";
      if (entry.path().filename().string().find(".writing-") == std::string::npos ||
          fs::exists(entry.path() / ".loosefit-writing") || !fs::exists(left / "log.jsonl"))
        continue;
      EXPECT_EQ(c.way, Way::create);
      for (const auto& [file, text] : files)
        EXPECT_EQ(read_text_file((left / file).string(), 1000), text) << file;
      fs::remove_all(entry.path());
    }
}

struct Counts {
  int committed = 0, refused = 0, failed = 0, killed = 0, half = 0;
};

void run_case(unsigned seed, const fs::path& base, Counts& counts) {
  Case c(seed, base);
  c.make_world();
  const Files files = c.draw_files();
  const Way way = c.way;
  const Trouble trouble = c.chance(25)   ? static_cast<Trouble>(c.draw(2))
                          : c.chance(25) ? Trouble::full_disk
                                         : Trouble::fault;
  const auto plan_of_fault = [&c] {
    faults::Plan plan;
    plan.fault = c.chance(60)   ? faults::Fault::kill
                 : c.chance(50) ? faults::Fault::fail_once
                                : faults::Fault::fail_ever;
    plan.at = 1 + c.draw(c.chance(30) ? 20 : 110);
    plan.error = c.chance(50) ? ENOSPC : EIO;
    return plan;
  };
  const faults::Plan plan = plan_of_fault();
  const bool set_aside = way == Way::update && !fs::exists(c.out / kOutputMark);
  const Tree before = tree_of(base);
  const Ending ending =
      write_in_child(c, files, way, c.chance(60), trouble, plan, 50 + c.draw(2000));
  check_saved_elsewhere(c, files);
  ASSERT_TRUE(ending.killed || (ending.code >= 0 && ending.code <= 3)) << ending.code;

  const Tree after = tree_of(base);
  expect_foreign_untouched(c, before, after, files, set_aside);
  if (ending.killed) {
    ++counts.killed;
    counts.half += !difference(before, after).empty();
  } else if (ending.code == 0) {
    ++counts.committed;
    if (trouble != Trouble::fault) expect_all_new(c, before, after, files, way);
  } else {
    ++(ending.code == 1 ? counts.refused : counts.failed);
    if (trouble != Trouble::fault) {
      EXPECT_EQ(difference(before, after), "");
    }
  }
  // Whoever comes next finds the folder repaired and tidy, even if a repair was cut short too.
  if (c.chance(30)) write_in_child(c, {}, way, false, Trouble::fault, plan_of_fault(), 0);
  write_files(c.out, {}, Way::create, false, true);
  expect_old_or_new(c, before, files, way, set_aside);
}

TEST(RunFolderFuzz, NothingForeignChangesAndOursAreAllOldOrAllNew) {
  const fs::path memory = "/dev/shm";  // where there is one: thousands of folders wear no disk
  const support::ScratchFolder base(access(memory.c_str(), W_OK) == 0 ? memory
                                                                      : fs::temp_directory_path());
  Counts counts;
  for (unsigned seed = 0; seed < 1500 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base.clear();
    run_case(seed, base, counts);
  }
  std::printf("committed %d, refused %d, failed %d, killed %d (%d half-way)\n", counts.committed,
              counts.refused, counts.failed, counts.killed, counts.half);
  EXPECT_GT(counts.committed, 300);
  EXPECT_GT(counts.refused, 200);
  EXPECT_GT(counts.failed, 150);
  EXPECT_GT(counts.half, 200) << "the kills strike while files are being replaced";
}

}  // namespace
}  // namespace loosefit::io
