#include "loosefit/study/untold_modalities.h"

#include <algorithm>
#include <set>
#include <utility>

#include "loosefit/base/text.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/placement/metric_names.h"
#include "loosefit/study/measure_case.h"

namespace loosefit::study {

std::vector<UntoldModality> untold_modalities(const Plan& plan) {
  // Nothing else of a scenario decides what it can tell.
  std::set<std::pair<bool, bool>> kinds;
  for (const PlannedCase& one : plan.cases)
    kinds.emplace(one.several_postures, one.several_donnings);
  std::vector<UntoldModality> untold;
  for (const std::string& modality : plan.study.modalities) {
    const placement::Scorecard card = io::load_scorecard(modality);
    UntoldModality one{.modality = card.name, .metrics = {}};
    std::set<std::string> told;
    for (const auto& [postures, donnings] : kinds) {
      for (const placement::Criterion& criterion : tellable(card, postures, donnings).criteria)
        told.insert(criterion.metric);
    }
    for (const placement::Criterion& criterion : card.criteria) {
      const std::string words = placement::metric_with_need(criterion.metric);
      if (!told.contains(criterion.metric) && !std::ranges::count(one.metrics, words))
        one.metrics.push_back(words);
    }
    one.rated = !told.empty();
    if (!plan.cases.empty() && !one.metrics.empty()) untold.push_back(std::move(one));
  }
  return untold;
}

std::string untold_text(const UntoldModality& untold) {
  return untold.modality + ": no case can tell " + join(untold.metrics) +
         (untold.rated ? ": scores leave that out and are upper bounds"
                       : ": nothing will be rated");
}

}  // namespace loosefit::study
