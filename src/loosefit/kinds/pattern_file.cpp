#include "loosefit/kinds/pattern_file.h"

namespace loosefit::kinds {

GarmentKind pattern_file() {
  GarmentKind kind;
  kind.name = pattern::Pattern{}.kind;
  kind.title = "pattern file";
  for (const char* name : {"chest", "waist", "hip", "upper_arm", "wrist", "thigh", "knee"})
    kind.measures.push_back({name, name, 0.05, 3, "m", false});
  for (const char* name :
       {"hps_to_bust", "hps_to_waist", "hps_to_hip", "crotch_height", "hip_level", "arm_length"})
    kind.measures.push_back({name, name, 0.05, 2, "m", false});
  kind.levels = [](const pattern::Pattern&, const BodyMeasures&, const NamedValues&) {
    return std::vector<FitLevel>{};
  };
  kind.note_parts = [](pattern::Pattern&) { return false; };
  return kind;
}

}  // namespace loosefit::kinds
