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
inline std::vector<Vec3> dress_shirt(const Garment& shirt, const Body& body) {
  return lay_round(shirt, body, lay_shirt);
}

/// The fit that a kind of shirt has where nothing else is asked for.
inline ShirtFit usual_fit(const std::string& kind) {
  NamedValues values;
  for (const KindKey& key : garment_kind(kind).keys)
    if (key.usual) values[key.name] = *key.usual;
  return shirt_fit_of(values);
}

struct ShirtSize {
  ShirtMeasures body;
  ShirtFit fit;
};
inline ShirtSize shirt_size(const std::string& name) {
  const KindSize& size = find_size(shirt_sizes(), name);
  return {shirt_measures_of(size.measures), shirt_fit_of(size.fit)};
}
inline std::vector<std::string> shirt_size_names() { return size_names(shirt_sizes()); }

}  // namespace loosefit::support
