#include "loosefit/validate/benchmark.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/check.h"

namespace loosefit::validate {

std::string name(Verdict verdict) {
  switch (verdict) {
    case Verdict::reported:
      return "reported";
    case Verdict::pass:
      return "pass";
    case Verdict::known_miss:
      return "known miss";
    case Verdict::unexpected_pass:
      return "unexpected pass";
    case Verdict::miss:
      return "MISS";
  }
  return "";
}

bool is_as_stated(Verdict verdict) {
  return verdict != Verdict::miss && verdict != Verdict::unexpected_pass;
}

double Finding::error() const {
  if (gate == Gate::range) {
    if (!std::isfinite(obtained)) return obtained;
    return std::max({0.0, low - obtained, obtained - high});
  }
  const double difference = std::abs(obtained - expected);
  return gate == Gate::relative ? difference / std::abs(expected) : difference;
}

double Finding::share_of_gate() const {
  if (gate == Gate::reported) return 0;
  if (!std::isfinite(error())) return HUGE_VAL;
  if (gate != Gate::range) return limit > 0 ? error() / limit : error() > 0 ? HUGE_VAL : 0;
  const bool below = std::isfinite(low), above = std::isfinite(high);
  if (below && above && high > low) return std::abs(2 * obtained - low - high) / (high - low);
  // One end: how far the figure is from it, in units of the bound.
  const double bound = below ? low : high, scale = std::max(std::abs(bound), 1e-9);
  return std::max(0.0, 1 + (below ? bound - obtained : obtained - bound) / scale);
}

bool Finding::pass() const {
  if (!std::isfinite(obtained)) return false;
  if (gate == Gate::range) return low <= obtained && obtained <= high;
  return gate == Gate::reported || error() <= limit;
}

Verdict Finding::verdict() const {
  if (!std::isfinite(obtained)) return Verdict::miss;
  if (gate == Gate::reported) return Verdict::reported;
  if (pass()) return known_miss ? Verdict::unexpected_pass : Verdict::pass;
  return known_miss && error() <= known_miss->most ? Verdict::known_miss : Verdict::miss;
}

Finding in_range(std::string what, std::string unit, double expected, double obtained, double low,
                 double high, std::string mesh) {
  Finding f;
  f.what = std::move(what);
  f.unit = std::move(unit);
  f.expected = expected;
  f.obtained = obtained;
  f.gate = Finding::Gate::range;
  f.mesh = std::move(mesh);
  f.low = low;
  f.high = high;
  return f;
}

Finding whole_count(std::string what, int all, int obtained, std::string mesh, int wrong,
                    std::string reason) {
  require(wrong >= 0 && wrong < all, "a count of which fewer than all are known to be wrong");
  Finding f = in_range(std::move(what), "", all, obtained, all, all, std::move(mesh));
  if (wrong > 0) f.known_miss = KnownMiss{static_cast<double>(wrong), std::move(reason)};
  return f;
}

}  // namespace loosefit::validate
