#include "loosefit/validate/benchmark.h"

#include <cmath>

namespace loosefit::validate {

double Finding::error() const {
  const double difference = std::abs(obtained - expected);
  return gate == Gate::relative ? difference / std::abs(expected) : difference;
}

bool Finding::pass() const {
  if (!std::isfinite(obtained)) return false;
  return gate == Gate::reported || error() <= limit;
}

}  // namespace loosefit::validate
