#include "loosefit/io/plain_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

IoError failed(const fs::path& path, const char* what) {
  return IoError(path.string() + ": " + what + ": " + std::strerror(errno));
}

constexpr std::size_t kLargest = std::size_t(1) << 32;  ///< of a file that we wrote [bytes]

}  // namespace

bool is_there(const fs::path& path) {
  struct stat found;
  return lstat(path.c_str(), &found) == 0;
}

Standing standing(const fs::path& folder, const std::string& name) {
  fs::path at = folder;
  const fs::path relative(name);
  for (auto part = relative.begin(); part != relative.end(); ++part) {
    at /= *part;
    struct stat found;
    if (lstat(at.c_str(), &found) != 0)
      return errno == ENOENT ? Standing::nothing : Standing::other;
    const bool last = std::next(part) == relative.end();
    if (last && S_ISREG(found.st_mode)) return Standing::plain_file;
    if (!S_ISDIR(found.st_mode)) return Standing::other;
    if (last) return Standing::folder;
  }
  return Standing::other;
}

std::optional<std::string> plain_digest(const fs::path& folder, const std::string& name) {
  if (standing(folder, name) != Standing::plain_file) return {};
  return sha256_hex(read_text_file((folder / name).string(), kLargest));
}

std::vector<std::string> plain_files(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (fs::is_regular_file(entry->symlink_status()))
      names.push_back(entry->path().lexically_relative(folder).generic_string());
  if (error) throw IoError(folder.string() + ": cannot be read: " + error.message());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> missing_folders(const fs::path& folder,
                                         const std::set<std::string>& names) {
  std::set<std::string> missing;  // sorted: "a" comes before "a/b"
  for (const std::string& name : names)
    for (fs::path up = fs::path(name).parent_path(); !up.empty(); up = up.parent_path())
      if (!is_there(folder / up)) missing.insert(up.generic_string());
  return {missing.begin(), missing.end()};
}

void move_to_free_name(const fs::path& from, const fs::path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return;
  // Some file systems (NFS) do not know this kind of rename.
  const bool unknown = errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP;
  if (unknown && is_there(to)) errno = EEXIST;
  if (!unknown || is_there(to) || std::rename(from.c_str(), to.c_str()) != 0)
    throw failed(to, "cannot be written");
}

void move_over(const fs::path& from, const fs::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) throw failed(to, "cannot be written");
}

void make_folder(const fs::path& folder) {
  if (mkdir(folder.c_str(), 0777) == 0) return;
  struct stat found;
  if (errno == EEXIST && lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode)) return;
  throw failed(folder, "cannot make the folder");
}

void remove_if_empty(const fs::path& folder, const std::string& name) {
  if (standing(folder, name) == Standing::folder) rmdir((folder / name).c_str());
}

void sync_to_disk(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) throw failed(path, "cannot be written");
  // EINVAL: a file system that has nothing to wait for.
  const bool done = fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
  const int cause = errno;
  close(descriptor);
  errno = cause;
  if (!done) throw failed(path, "cannot be written");
}

bool same_mount(const fs::path& a, const fs::path& b) {
  struct statx of_a, of_b;
  const unsigned mask = STATX_BASIC_STATS | STATX_MNT_ID;
  if (statx(AT_FDCWD, a.c_str(), 0, mask, &of_a) != 0 ||
      statx(AT_FDCWD, b.c_str(), 0, mask, &of_b) != 0)
    return false;
  // A folder that is bound to another place has the same device there, and yet no rename crosses.
  const bool told = (of_a.stx_mask & STATX_MNT_ID) && (of_b.stx_mask & STATX_MNT_ID);
  return of_a.stx_dev_major == of_b.stx_dev_major && of_a.stx_dev_minor == of_b.stx_dev_minor &&
         (!told || of_a.stx_mnt_id == of_b.stx_mnt_id);
}

FileLock::FileLock(const fs::path& path, bool wait, bool unknown)
    // Over NFS only a file that is open for writing can be locked; a folder cannot be opened so.
    : descriptor_(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW)) {
  if (descriptor_ < 0) descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor_ < 0) {
    holds_ = unknown;
    return;
  }
  int result = 0;
  do result = flock(descriptor_, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
  while (result != 0 && errno == EINTR);
  holds_ = result == 0 || (errno != EWOULDBLOCK && unknown);
}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(other.descriptor_), holds_(other.holds_) {
  other.descriptor_ = -1;
  other.holds_ = false;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace loosefit::io
