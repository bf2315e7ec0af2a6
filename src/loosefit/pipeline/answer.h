#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/footprint.h"

namespace loosefit::pipeline {

/// What to do about one sensor and what to expect of it, as values and as the sentences that page,
/// terminal and summary.json show. Sentences begin with a capital and end with a full stop; empty
/// ones have nothing to say.
struct Answer {
  std::string modality;  ///< name of the scorecard
  std::string sensor;    ///< its title
  std::string site;      ///< name of the place: a preset, a [[site]], best_1; of a line its name
  bool asked = false;    ///< by [ranking] or [[site]]; else one of the usual sensors
  std::optional<bool> passes;  ///< by the robust score; absent: undecided or not rated

  // What is expected: median, least and greatest over the samples.
  std::string metric, unit;  ///< of metric_vocabulary(); empty: nothing known
  double expected = 0, low = 0, high = 0;
  std::optional<double> mesh_error = {};  ///< of one value (maps/mesh_error.h); absent: not known
  int samples = 0, passing = 0, people = 1;

  std::string place, expectation, verdict, limit, need, pass_mark;

  // Where it lies in the pattern, for a picture; of a line nothing.
  std::string panel;
  Vec2 at = Vec2::Zero();
  double angle = 0;  ///< of the axis [rad]
  placement::FootprintShape shape = {};
  std::vector<std::string> files;  ///< of the output, to sew by

  /// All sentences but the pass mark.
  std::string text() const;
};

}  // namespace loosefit::pipeline
