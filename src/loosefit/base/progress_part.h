#pragma once
#include "loosefit/base/progress.h"

namespace loosefit {

/// Shows work as the part of a stage that it is, `share` of it from `from` on (both in [0,1]), and
/// passes on the wish to stop. Stages inside the part are no stages of the whole.
class ProgressPart : public Progress {
 public:
  ProgressPart(Progress& whole, double from, double share)
      : whole_(whole), from_(from), share_(share) {}
  void update(double fraction, const std::string& note) override {
    whole_.update(from_ + share_ * fraction, note);
  }
  void check_cancelled() const override { whole_.check_cancelled(); }

 private:
  Progress& whole_;
  double from_, share_;
};

}  // namespace loosefit
