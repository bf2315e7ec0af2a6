#include "loosefit/kinds/registry.h"

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/kinds/hoodie/hoodie.h"
#include "loosefit/kinds/pattern_file.h"
#include "loosefit/kinds/shirt/shirt.h"
#include "loosefit/kinds/tank_top/tank_top.h"
#include "loosefit/kinds/trousers/trousers.h"

namespace loosefit::kinds {

const std::vector<GarmentKind>& garment_kinds() {
  static const std::vector<GarmentKind> kKinds = {
      long_sleeve_shirt(), t_shirt(), tank_top(), hoodie(), trousers(), leggings(), pattern_file()};
  return kKinds;
}

const GarmentKind& garment_kind(const std::string& name) {
  for (const GarmentKind& kind : garment_kinds())
    if (kind.name == name) return kind;
  throw InvalidInput({{}, 0, "pattern"}, '"' + printable(name) + '"', "a kind of garment",
                     did_you_mean(name, drafted_kinds()));
}

std::vector<std::string> drafted_kinds() {
  std::vector<std::string> names;
  for (const GarmentKind& kind : garment_kinds())
    if (kind.draft) names.push_back(kind.name);
  return names;
}

}  // namespace loosefit::kinds
