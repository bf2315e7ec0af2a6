#pragma once
#include <filesystem>
#include <optional>

namespace loosefit {

/// What the control groups of this process (Linux, versions 1 and 2) let it have. The tightest
/// group counts, from its own up to the root. Empty: no limit, or none that can be read.
/// Source: Linux kernel, Documentation/admin-guide/cgroup-v1 and cgroup-v2.rst.
struct GroupLimits {
  std::optional<double> cores;         ///< processor time per time: 1.5 is one and a half cores
  std::optional<double> memory_bytes;  ///< before the kernel ends the process
};

/// `membership`: /proc/self/cgroup. `mounts`: the folder in which the hierarchies are mounted.
GroupLimits group_limits(const std::filesystem::path& membership = "/proc/self/cgroup",
                         const std::filesystem::path& mounts = "/sys/fs/cgroup");

}  // namespace loosefit
