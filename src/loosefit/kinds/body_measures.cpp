#include "loosefit/kinds/body_measures.h"

#include "loosefit/base/error.h"

namespace loosefit::kinds {

BodyMeasures known_measures(const GarmentKind& kind, const std::map<std::string, double>& measured,
                            const GirthsAlong& along) {
  BodyMeasures values;
  values.along = along;
  for (const KindMeasure& m : kind.measures)
    if (const auto found = measured.find(m.of_body); found != measured.end())
      values[m.name] = found->second;
  return values;
}

BodyMeasures draft_measures(const GarmentKind& kind, const std::map<std::string, double>& measured,
                            const GirthsAlong& along) {
  for (const KindMeasure& m : kind.measures)
    if (m.required && !measured.count(m.of_body))
      throw InvalidInput({"", 0, "body." + m.of_body}, "no such measure on this body",
                         "one for the draft of a " + kind.title,
                         kind.sizes.empty()
                             ? "give a pattern file instead of a fit"
                             : "give a garment size or a pattern file instead of a fit");
  return known_measures(kind, measured, along);
}

}  // namespace loosefit::kinds
