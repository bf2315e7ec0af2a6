#include "loosefit/kinds/girth_line.h"

#include <algorithm>

namespace loosefit::kinds {

std::optional<double> girth_at(const GirthLine& line, double along) {
  constexpr double kRounding = 1e-9;  // of multiples of a step [m]
  if (line.empty() || along < line.front().along - kRounding ||
      along > line.back().along + kRounding)
    return std::nullopt;
  const auto next = std::lower_bound(line.begin(), line.end(), along,
                                     [](const GirthAt& g, double a) { return g.along < a; });
  if (next == line.begin()) return next->girth;
  if (next == line.end()) return line.back().girth;
  const GirthAt &a = *(next - 1), &b = *next;
  return a.girth + (along - a.along) / (b.along - a.along) * (b.girth - a.girth);
}

}  // namespace loosefit::kinds
