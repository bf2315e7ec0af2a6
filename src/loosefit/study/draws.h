#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace loosefit::study {

/// Quantile of the standard normal distribution, 0 < p < 1 (Wichura 1988, AS 241, relative error
/// below 1e-15). \throws InvalidInput outside.
double normal_quantile(double p);

/// Random numbers that depend on the seed only, not on the standard library.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : generator_(seed) {}
  /// Evenly in (0, 1), never at the ends.
  double uniform();
  double normal() { return normal_quantile(uniform()); }

 private:
  std::mt19937_64 generator_;
};

/// A seed for one use of a study, so that another axis, or another order of axes, changes no draw
/// of this one.
std::uint64_t seed_for(std::uint64_t study_seed, const std::string& use);

/// One number from each of `count` equal parts of (0, 1), in random order: one column of a Latin
/// hypercube (McKay, Beckman and Conover 1979).
std::vector<double> stratified(int count, std::uint64_t seed);

}  // namespace loosefit::study
