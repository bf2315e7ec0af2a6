#pragma once
#include <string>
#include <vector>

#include "loosefit/dress/lay_round.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/kinds/shirt/lay_shirt.h"
#include "loosefit/kinds/shirt/shirt_sizes.h"
#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::support {

/// A shirt with sleeves as it is laid round a body when it is worn alone.
inline std::vector<Vec3> dress_shirt(const garment::Garment& shirt, const body::Body& body) {
  return dress::lay_round(shirt, body, kinds::lay_shirt);
}

/// The fit that a kind of shirt has where nothing else is asked for.
inline kinds::ShirtFit usual_fit(const std::string& kind) {
  kinds::NamedValues values;
  for (const kinds::KindKey& key : kinds::garment_kind(kind).keys)
    if (key.usual) values[key.name] = *key.usual;
  return kinds::shirt_fit_of(values);
}

struct ShirtSize {
  kinds::ShirtMeasures body;
  kinds::ShirtFit fit;
};
inline ShirtSize shirt_size(const std::string& name) {
  const kinds::KindSize& size = kinds::find_size(kinds::shirt_sizes(), name);
  return {kinds::shirt_measures_of(size.measures), kinds::shirt_fit_of(size.fit)};
}
inline std::vector<std::string> shirt_size_names() {
  return kinds::size_names(kinds::shirt_sizes());
}

}  // namespace loosefit::support
