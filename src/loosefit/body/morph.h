#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "loosefit/body/body_data.h"
#include "loosefit/body/body_parameters.h"

namespace loosefit::body {

/// Turns parameters into row positions: base + Σ weight · field (MakeHuman's linear morph targets).
class Morph {
 public:
  /// Keeps a reference: the data must outlive the morph.
  explicit Morph(const BodyData& data);

  /// Weight of every field with a weight above 1e-9, ascending by field.
  std::vector<std::pair<int, double>> weights(const BodyParameters& parameters) const;
  /// Position of every row [m], rest posture, floor not yet at zero.
  std::vector<Vec3> rows(const BodyParameters& parameters) const;

 private:
  struct MacroTarget {
    std::vector<int> words;  ///< indices into words_
    int field = -1;
  };
  struct Detail {
    std::string key;
    std::vector<int> decrease, increase;  ///< fields
  };
  std::vector<double> macro_weights(const BodyParameters& parameters) const;

  const BodyData* data_;
  std::vector<std::string> words_;
  std::vector<MacroTarget> macros_;
  std::vector<Detail> details_;
};

}  // namespace loosefit::body
