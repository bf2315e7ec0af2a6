#include "loosefit/drape/drape.h"

#include <algorithm>

namespace loosefit::drape {

void SettleReport::count(RecoveryKind kind, const std::string& name) {
  for (RecoveryCount& known : recoveries)
    if (known.kind == kind) {
      ++known.times;
      return;
    }
  recoveries.push_back({kind, name, 1});
}

bool SettleReport::was_tried(RecoveryKind kind) const {
  return std::any_of(recoveries.begin(), recoveries.end(),
                     [&](const RecoveryCount& one) { return one.kind == kind; });
}

}  // namespace loosefit::drape
