#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_parameters.h"
#include "loosefit/body/catmull_clark.h"
#include "loosefit/body/morph.h"
#include "loosefit/body/rest_body.h"

namespace loosefit {

/// The wearer as asked for, in metres. `measurements` takes any of measure_names() but "height".
struct BodySpec {
  double sex = 0.5;   ///< 0 female … 1 male; 0.3 … 0.5 for a child before puberty
  double age = 25;    ///< years
  double height = 0;  ///< stature [m]; 0: what the model gives for sex and age
  std::map<std::string, double> measurements;
  double muscle = 0.5;
  double proportions = 0.5;
  double cup = 0.5;
  double firmness = 0.5;
};

/// One line of asked against measured [m].
struct MeasureRow {
  std::string name;
  double asked = 0;
  double measured = 0;
};

/// What a fit found. A measure more than 5 mm off and a strained local change make a warning.
struct BodyFit {
  BodyParameters parameters;
  std::vector<MeasureRow> table;
  std::vector<std::string> warnings;
  int evaluations = 0;
};

/// Smoothed or as the data are: 53 514 or 13 380 vertices.
enum class BodyDetail { subdivided, coarse };

/// The parametric human body (MakeHuman's morph targets and rig; docs/theory/body_model.md).
class BodyModel {
 public:
  explicit BodyModel(BodyData data);
  /// \throws IoError when the baked file is missing (says: make setup).
  static BodyModel load(const std::string& path = default_body_data_path());

  /// Parameters whose body has the asked measures, by bounded Gauss-Newton on the surface that
  /// build() makes. \throws InvalidInput naming a measure that no person has, or a stature
  /// or trunk girth that the nearest body misses by more than a tenth.
  BodyFit fit(const BodySpec& spec, BodyDetail detail = BodyDetail::subdivided) const;

  /// The body in a posture, every field filled, floor at z = 0. \throws InvalidInput for parameters
  /// or angles out of range.
  Body build(const BodyParameters& parameters, const Posture& posture) const;

  /// The model's own A-pose for these parameters: arms about 41° from the vertical.
  Posture rest_posture(const BodyParameters& parameters) const;

  /// Surface and joints in rest posture, floor not yet at zero.
  RestBody rest(const BodyParameters& parameters, BodyDetail detail = BodyDetail::subdivided) const;

  const BodyData& data() const { return *data_; }

 private:
  double scye_depth(const RestBody& rest) const;

  std::shared_ptr<const BodyData> data_;
  Morph morph_;
  CatmullClark subdivision_;
  std::vector<Triangle> coarse_triangles_;
  std::vector<std::vector<std::pair<int, double>>> fine_skin_;
  std::vector<Segment> segment_;
  std::vector<int> side_;
};

}  // namespace loosefit
