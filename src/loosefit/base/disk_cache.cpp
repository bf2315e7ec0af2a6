#include "loosefit/base/disk_cache.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "loosefit/base/sha256.h"

namespace loosefit::disk_cache {

namespace fs = std::filesystem;

namespace {

constexpr char kSuffix[] = ".lfc", kUnfinished[] = ".lfc-new";
constexpr std::size_t kDigest = 64;   ///< characters before the result: the digest of the result
constexpr std::size_t kBlock = 4096;  ///< bytes of disk that a file takes at least
/// After a clearing so much of kMostBytes is left, so that not every result has to make room.
constexpr double kLeft = 0.75;
constexpr int kRoomEvery = 64;  ///< results that a process keeps between two looks at the folder

std::atomic<bool> is_on{false};

fs::path environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? fs::path(value) : fs::path();
}

struct Entry {
  fs::path path;
  std::size_t bytes = 0;
  fs::file_time_type used;
};

std::vector<Entry> entries(const fs::path& folder) {
  std::vector<Entry> all;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const fs::path suffix = at->path().extension();
    if (suffix != kSuffix && suffix != kUnfinished) continue;
    std::error_code gone, unknown;  // another process may clear the folder
    const std::size_t bytes = std::max<std::size_t>(at->file_size(gone), kBlock);
    const fs::file_time_type used = at->last_write_time(unknown);
    if (!gone && !unknown) all.push_back({at->path(), bytes, used});
  }
  return all;
}

void make_room(const fs::path& folder) {
  std::vector<Entry> all = entries(folder);
  std::size_t bytes = 0;
  for (const Entry& entry : all) bytes += entry.bytes;
  if (bytes <= kMostBytes) return;
  std::ranges::sort(all, {}, &Entry::used);
  std::error_code ignored;
  for (const Entry& entry : all) {
    if (static_cast<double>(bytes) <= kLeft * static_cast<double>(kMostBytes)) return;
    fs::remove(entry.path, ignored);
    bytes -= entry.bytes;
  }
}

}  // namespace

void turn_on(bool on) { is_on = on; }

fs::path folder() {
  if (!is_on) return {};
  const fs::path given = environment("LOOSEFIT_CACHE");
  if (given == "off") return {};
  if (given.is_absolute()) return given;
  if (const fs::path cache = environment("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "loosefit";
  const fs::path home = environment("HOME");
  return home.is_absolute() ? home / ".cache" / "loosefit" : fs::path();
}

std::optional<std::string> load(const std::string& key) {
  const fs::path in = folder();
  if (in.empty()) return std::nullopt;
  const fs::path path = in / (key + kSuffix);
  std::error_code gone;  // another process may clear the folder
  const std::uintmax_t size = fs::is_regular_file(path, gone) ? fs::file_size(path, gone) : 0;
  if (gone || size < kDigest || size > kMostBytes) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, 0);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) return std::nullopt;
  if (sha256_hex(std::string_view(bytes).substr(kDigest)) !=
      std::string_view(bytes).substr(0, kDigest))
    return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return bytes.substr(kDigest);
}

void store(const std::string& key, std::string_view bytes) {
  static std::atomic<int> number{0};
  const fs::path in = folder();
  if (in.empty()) return;
  std::error_code error;
  fs::create_directories(in, error);
  if (error) return;
  const int before = number++;
  const fs::path aside =
      in / (key + "." + std::to_string(getpid()) + "-" + std::to_string(before) + kUnfinished);
  bool whole = false;
  {
    std::ofstream file(aside, std::ios::binary);
    file << sha256_hex(bytes) << bytes;
    file.close();
    whole = !file.fail();
  }
  if (whole) fs::rename(aside, in / (key + kSuffix), error);
  if (!whole || error) fs::remove(aside, error);
  if (before % kRoomEvery == 0) make_room(in);
}

Size size() {
  Size size;
  if (const fs::path in = folder(); !in.empty())
    for (const Entry& entry : entries(in)) ++size.files, size.bytes += entry.bytes;
  return size;
}

}  // namespace loosefit::disk_cache
