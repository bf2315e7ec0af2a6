#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

namespace loosefit {

/// What became of the damaged files of one format. A case that is counted in none of the three has
/// crashed, or thrown what is no refusal. With LOOSEFIT_FUZZ_TALLY set the counts are appended to
/// that file as a line of JSON, from which tools/run_fuzz.py makes its table.
class FuzzTally {
 public:
  FuzzTally(std::string format, unsigned cases) : format_(std::move(format)), cases_(cases) {}
  FuzzTally(const FuzzTally&) = delete;
  FuzzTally& operator=(const FuzzTally&) = delete;

  ~FuzzTally() {
    EXPECT_EQ(refused_ + read_ + identical_, cases_) << format_ << ": cases without an outcome";
    const char* file = std::getenv("LOOSEFIT_FUZZ_TALLY");
    if (!file) return;
    std::ofstream(file, std::ios::app)
        << "{\"format\": \"" << format_ << "\", \"cases\": " << cases_
        << ", \"refused\": " << refused_ << ", \"read\": " << read_
        << ", \"identical\": " << identical_ << ", \"slowest_ms\": " << std::lround(slowest_ * 1e3)
        << ", \"failed\": " << (::testing::Test::HasFailure() ? "true" : "false") << "}\n";
  }

  /// Before every case.
  void begin() { start_ = Clock::now(); }
  /// The reader said no.
  void refuse() { end(refused_); }
  /// The reader gave pieces; `same` as of the whole file: the damage met nothing that it reads.
  void read(bool same) { end(same ? identical_ : read_); }

  /// At least that share was refused, and some files survived.
  void expect_real_damage(double least_refused) const {
    EXPECT_GT(refused_, least_refused * cases_) << format_;
    // Of fewer files all may have been damaged for good.
    if (cases_ >= 200) {
      EXPECT_LT(refused_, cases_) << format_;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  void end(unsigned& count) {
    ++count;
    slowest_ = std::max(slowest_, std::chrono::duration<double>(Clock::now() - start_).count());
  }

  std::string format_;
  unsigned cases_, refused_ = 0, read_ = 0, identical_ = 0;
  double slowest_ = 0;  ///< [s]
  Clock::time_point start_ = Clock::now();
};

}  // namespace loosefit
