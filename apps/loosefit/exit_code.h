#pragma once

namespace loosefit {

/// What the process returns to the shell.
enum ExitCode {
  kGood = 0,
  kNotSettled = 1,  ///< ran, but the drape did not settle or is not worn; also a numerical method
                    ///< that gave up
  kGateMissed = 1,  ///< a benchmark of `loosefit validate` is not as stated: a gate missed, or one
                    ///< met that is stated to be missed
  kBadInput = 2,    ///< bad input or usage, unreadable or unwritable files
  kInterrupted = 130
};

}  // namespace loosefit
