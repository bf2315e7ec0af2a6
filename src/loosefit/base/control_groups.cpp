#include "loosefit/base/control_groups.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace loosefit {
namespace fs = std::filesystem;
namespace {

/// The first number in a file; empty for "max", −1 and what cannot be read: no limit.
std::optional<double> limit_in(const fs::path& file) {
  double value = 0;
  if (std::ifstream(file) >> value && value > 0 && std::isfinite(value)) return value;
  return {};
}

void tighten(std::optional<double>& limit, const std::optional<double>& other) {
  if (other) limit = limit ? std::min(*limit, *other) : *other;
}

/// "QUOTA PERIOD" in microseconds, of version 2.
std::optional<double> cores_in(const fs::path& file) {
  double quota = 0, period = 0;
  if (std::ifstream(file) >> quota >> period && quota > 0 && period > 0) return quota / period;
  return {};
}

/// What this one group says, whichever version it is of.
void read_group(const fs::path& group, GroupLimits& limits) {
  tighten(limits.cores, cores_in(group / "cpu.max"));
  tighten(limits.memory_bytes, limit_in(group / "memory.max"));
  const auto quota = limit_in(group / "cpu.cfs_quota_us");
  const auto period = limit_in(group / "cpu.cfs_period_us");
  if (quota && period) tighten(limits.cores, *quota / *period);
  tighten(limits.memory_bytes, limit_in(group / "memory.limit_in_bytes"));
}

/// Folders at which the hierarchy of these controllers ("cpu,cpuacct"; empty: version 2) may be.
std::set<fs::path> hierarchies(const std::string& controllers, const fs::path& mounts) {
  if (controllers.empty()) return {mounts, mounts / "unified"};
  std::set<fs::path> found = {mounts / controllers};
  std::istringstream names(controllers);
  for (std::string name; std::getline(names, name, ',');) found.insert(mounts / name);
  return found;
}

}  // namespace

GroupLimits group_limits(const fs::path& membership, const fs::path& mounts) {
  GroupLimits limits;
  std::ifstream lines(membership);
  for (std::string line; std::getline(lines, line);) {  // NUMBER:CONTROLLERS:GROUP
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    // In a container the group may be named as the host sees it: then only the root is there.
    const fs::path own = fs::path(line.substr(second + 1)).relative_path();
    for (const fs::path& root : hierarchies(line.substr(first + 1, second - first - 1), mounts)) {
      for (fs::path group = own; !group.empty(); group = group.parent_path())
        read_group(root / group, limits);
      read_group(root, limits);
    }
  }
  return limits;
}

}  // namespace loosefit
