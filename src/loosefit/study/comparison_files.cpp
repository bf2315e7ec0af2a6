#include "loosefit/study/comparison_files.h"

#include <unistd.h>

#include <system_error>
#include <utility>
#include <vector>

#include "loosefit/io/plain_files.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/whole_file.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

fs::path limits_beside(fs::path file) { return file.replace_extension(".limits.csv"); }

/// A whole file that waits beside its place, and is gone with its owner when it has not come there.
class WaitingFile {
 public:
  WaitingFile(const fs::path& place, const std::string& text)
      : place_(place),
        path_(place.parent_path() /
              ("." + place.filename().string() + "." + std::to_string(getpid()) + ".part")) {
    try {
      io::write_text_file(path_.string(), text);
      io::sync_to_disk(path_);
    } catch (...) {
      remove();
      throw;
    }
  }
  ~WaitingFile() { remove(); }
  WaitingFile(const WaitingFile&) = delete;
  WaitingFile& operator=(const WaitingFile&) = delete;
  void take_place(bool may_replace) const {
    may_replace ? io::move_over(path_, place_) : io::move_to_free_name(path_, place_);
  }

 private:
  void remove() const {
    std::error_code error;
    fs::remove(path_, error);
  }
  fs::path place_, path_;
};

}  // namespace

void check_comparison_files(const fs::path& file, bool may_replace) {
  for (const fs::path& one : {file, limits_beside(file)}) io::check_whole_file(one, may_replace);
}

void write_comparison(const StudyComparison& comparison, const fs::path& file, bool may_replace) {
  check_comparison_files(file, may_replace);
  const WaitingFile scores(file, comparison_csv(comparison));
  const WaitingFile limits(limits_beside(file), limits_csv(comparison));
  scores.take_place(may_replace);
  limits.take_place(may_replace);
}

}  // namespace loosefit::study
