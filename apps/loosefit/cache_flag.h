#pragma once
#include <CLI/App.hpp>
#include <cstdlib>

namespace loosefit {

/// Adds `--no-cache` to a command: neither it nor a process that it starts uses the disk cache.
inline void add_cache_flag(CLI::App& command) {
  command.add_flag_callback(
      "--no-cache", [] { setenv("LOOSEFIT_CACHE", "off", 1); },
      "make bodies anew instead of taking them from earlier runs");
}

}  // namespace loosefit
