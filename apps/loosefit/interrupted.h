#pragma once
#include "loosefit/base/error.h"

namespace loosefit {

/// Ctrl-C has ended work of which something stays: the message says what. Exit code kInterrupted.
class Interrupted : public Error {
 public:
  using Error::Error;
};

}  // namespace loosefit
