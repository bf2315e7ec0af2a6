#include "loosefit/body/morph.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"

namespace loosefit::body {
namespace {

constexpr double kShiftUnit = 1e-4;  // metres per unit of a field
constexpr double kNegligible = 1e-9;

}  // namespace

Morph::Morph(const BodyData& data) : data_(&data) {
  for (const auto& [word, factor] : macro_factors({})) words_.push_back(word);
  for (const auto& [name, field] : data.field_of_name) {
    const auto words = macro_words(name);
    if (words.empty()) continue;
    MacroTarget target{{}, field};
    for (const auto& word : words) {
      const auto found = std::lower_bound(words_.begin(), words_.end(), word);
      if (found == words_.end() || *found != word) {
        throw IoError("body data: the target " + name + " has the unknown word " + word,
                      "run: loosefit setup");
      }
      target.words.push_back(int(found - words_.begin()));
    }
    macros_.push_back(std::move(target));
  }
  const auto fields = [&](const std::vector<std::string>& names) {
    std::vector<int> found;
    for (const auto& name : names) {
      const auto entry = data.field_of_name.find(name);
      if (entry == data.field_of_name.end()) {
        throw IoError("body data: the target " + name + " is missing", "run: loosefit setup");
      }
      if (entry->second >= 0) found.push_back(entry->second);
    }
    return found;
  };
  for (const auto& target : detail_targets()) {
    details_.push_back({target.key, fields(target.decrease), fields(target.increase)});
  }
}

std::vector<double> Morph::macro_weights(const BodyParameters& parameters) const {
  std::vector<double> factor;
  for (const auto& [word, value] : macro_factors(parameters)) factor.push_back(value);
  std::vector<double> weights;
  weights.reserve(macros_.size());
  for (const auto& target : macros_) {
    double weight = 1;
    for (const int word : target.words) weight *= factor[std::size_t(word)];
    weights.push_back(weight);
  }
  return weights;
}

std::vector<std::pair<int, double>> Morph::weights(const BodyParameters& parameters) const {
  std::map<int, double> sum;
  const auto macro = macro_weights(parameters);
  for (std::size_t i = 0; i < macros_.size(); ++i) {
    if (macros_[i].field >= 0 && std::abs(macro[i]) > kNegligible)
      sum[macros_[i].field] += macro[i];
  }
  for (const auto& detail : details_) {
    const auto asked = parameters.details.find(detail.key);
    if (asked == parameters.details.end() || asked->second == 0) continue;
    const auto& fields = asked->second > 0 ? detail.increase : detail.decrease;
    for (const int field : fields) sum[field] += std::abs(asked->second);
  }
  return {sum.begin(), sum.end()};
}

std::vector<Vec3> Morph::rows(const BodyParameters& parameters) const {
  std::vector<Vec3> position = data_->base;
  for (const auto& [index, weight] : weights(parameters)) {
    const BodyField& field = data_->fields[std::size_t(index)];
    const double scale = kShiftUnit * weight;
    for (std::size_t i = 0; i < field.rows.size(); ++i) {
      const auto& s = field.shift[i];
      position[field.rows[i]] += scale * Vec3(s[0], s[1], s[2]);
    }
  }
  if (parameters.shift)
    for (std::size_t v = 0; v < parameters.shift->size(); ++v)
      position[v] += (*parameters.shift)[v];
  return position;
}

}  // namespace loosefit::body
