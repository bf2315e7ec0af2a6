#include "loosefit/kinds/shirt/shirt_variants.h"

#include "loosefit/kinds/shirt/shirt_draft.h"

namespace loosefit::kinds {

const std::vector<pattern::Pattern>& shirt_variants() {
  static const std::vector<pattern::Pattern> kVariants = [] {
    ShirtMeasures full;
    full.bust_balance = full.front_balance = 0.03;
    std::vector<pattern::Pattern> drafts;
    for (const double back_waist : {0.0, 0.03})
      for (const double bust_dart : {0.0, 1.0})
        for (const double elbow_bend : {0.0, 15.0})
          for (const double neckband : {0.0, 0.02})
            for (const double cuff : {0.0, 0.04}) {
              ShirtFit fit;
              fit.back_waist = back_waist;
              fit.bust_dart = bust_dart;
              fit.elbow_bend = elbow_bend;
              fit.neckband = neckband;
              fit.cuff = cuff;
              drafts.push_back(draft_shirt(full, fit));
            }
    return drafts;
  }();
  return kVariants;
}

}  // namespace loosefit::kinds
