#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Results that follow from their key alone, kept on disk between runs. A result is one file, which
/// appears whole or not at all, so several processes may share the folder. A damaged file counts as
/// absent. Beyond kMostBytes those go that nobody asked for longest. What cannot be read or written
/// is no error: the result is made again.
namespace loosefit::disk_cache {

inline constexpr std::size_t kMostBytes = std::size_t{512} << 20;

/// Off until a program turns it on. For the whole process.
void turn_on(bool on);

/// $LOOSEFIT_CACHE ("off" turns it off), $XDG_CACHE_HOME/loosefit or ~/.cache/loosefit. Empty: off,
/// or none of them is set.
std::filesystem::path folder();

/// `key`: a digest of everything that the result follows from, the program's build included.
std::optional<std::string> load(const std::string& key);
void store(const std::string& key, std::string_view bytes);

struct Size {
  std::size_t files = 0, bytes = 0;  ///< of disk
};
Size size();

}  // namespace loosefit::disk_cache
