#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loosefit::io {

// Files of a folder by their name relative to it ("maps/strain-front.png"), looked at without ever
// following a symbolic link below the folder: what lies behind one is not part of the folder.

/// What stands at a name. `other`: a link, a device, or something that is not a folder (a link to
/// one included) on the way to it.
enum class Standing { nothing, plain_file, folder, other };
Standing standing(const std::filesystem::path& folder, const std::string& name);

/// Whether anything has this name, were it a link to nothing.
bool is_there(const std::filesystem::path& path);

/// SHA-256 of a plain file; nothing where there is none. \throws IoError if it cannot be read.
std::optional<std::string> plain_digest(const std::filesystem::path& folder,
                                        const std::string& name);

/// Names of all plain files below a folder, sorted.
std::vector<std::string> plain_files(const std::filesystem::path& folder);

/// Folders on the way to these files that are not there yet, the outer ones first.
std::vector<std::string> missing_folders(const std::filesystem::path& folder,
                                         const std::set<std::string>& names);

/// Moves a file or folder within one file system. \throws IoError, also if anything stands at `to`.
void move_to_free_name(const std::filesystem::path& from, const std::filesystem::path& to);

/// Moves a file; what stood at `to` is gone in the same instant. \throws IoError
void move_over(const std::filesystem::path& from, const std::filesystem::path& to);

/// \throws IoError naming the folder; one that is there already will do.
void make_folder(const std::filesystem::path& folder);

/// Removes a folder if nothing is in it and no link leads to it.
void remove_if_empty(const std::filesystem::path& folder, const std::string& name);

/// Waits until the disk has a file, or the names in a folder. \throws IoError
void sync_to_disk(const std::filesystem::path& path);

/// Whether a name can be moved from one folder to the other: both lie in one mounted file system.
bool same_mount(const std::filesystem::path& a, const std::filesystem::path& b);

/// An exclusive lock on a file or folder that the system releases when the process ends.
class FileLock {
 public:
  /// Takes the lock; `wait` for others to release it. Where the file system has no locks, or
  /// nothing is there, holds() is true or false as `unknown`.
  FileLock(const std::filesystem::path& path, bool wait, bool unknown);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  bool holds() const { return holds_; }

 private:
  int descriptor_ = -1;
  bool holds_ = false;
};

}  // namespace loosefit::io
