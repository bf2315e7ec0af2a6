#include "loosefit/kinds/check_values.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"

namespace loosefit::kinds {
namespace {

void in_range(const std::string& key, double value, double low, double high,
              const std::string& unit) {
  if (value >= low && value <= high) return;  // false for NaN too
  throw InvalidInput({{}, 0, key}, fmt::format("{:.6g}", value),
                     fmt::format("{} from {:g} to {:g}", unit, low, high));
}

}  // namespace

void check_values(const std::vector<KindMeasure>& measures, const NamedValues& body,
                  const std::vector<KindKey>& keys, const NamedValues& fit) {
  for (const KindMeasure& m : measures) {
    const auto value = body.find(m.name);
    if (value == body.end() && !m.required) continue;
    if (value == body.end())
      throw InvalidInput({{}, 0, "measures." + m.name}, "nothing", "this measure in " + m.unit);
    in_range("measures." + m.name, value->second, m.low, m.high, m.unit);
  }
  for (const KindKey& key : keys)
    if (const auto value = fit.find(key.name); value != fit.end())
      in_range("fit." + key.name, value->second, key.low, key.high, key.unit);
}

}  // namespace loosefit::kinds
