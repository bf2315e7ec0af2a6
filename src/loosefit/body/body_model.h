#pragma once
#include <memory>
#include <string>
#include <vector>

#include "loosefit/base/paths.h"
#include "loosefit/body/body.h"
#include "loosefit/body/body_parameters.h"
#include "loosefit/body/catmull_clark.h"
#include "loosefit/body/morph.h"
#include "loosefit/body/posed_person.h"
#include "loosefit/body/rest_body.h"

namespace loosefit::body {

/// Smoothed or as the data are: 53 514 or 13 380 vertices.
enum class BodyDetail { subdivided, coarse };

/// The parametric human body (MakeHuman's morph targets and rig; docs/theory/body_model.md).
class BodyModel {
 public:
  explicit BodyModel(BodyData data);
  /// \throws IoError when the baked file is missing (says: loosefit setup).
  static BodyModel load(const std::string& path = default_body_data_path());

  /// The body in a posture, every field filled, floor at z = 0. \throws InvalidInput for parameters
  /// or angles out of range.
  Body build(const BodyParameters& parameters, const Posture& posture) const;

  /// The same in any pose and place, which decides where the floor is.
  Body build(const PosedPerson& person) const;

  /// What build makes first: it need not be made again for every posture of a person. \throws as
  /// build, for the parameters.
  BodyShape shape(const BodyParameters& parameters) const;
  Body posed(const BodyShape& shape, const Posture& posture) const;

  /// The vertices of posed(shape, posture).surface, which take a third of its time.
  std::vector<Vec3> vertices(const BodyShape& shape, const Posture& posture) const;

  /// The model's own A-pose for these parameters: arms about 41° from the vertical.
  Posture rest_posture(const BodyParameters& parameters) const;

  /// Surface and joints in rest posture, floor not yet at zero.
  RestBody rest(const BodyParameters& parameters, BodyDetail detail = BodyDetail::subdivided) const;

  const BodyData& data() const { return *data_; }
  /// (bone, weight) of each vertex of the subdivided surface, sum 1; and its body part.
  const std::vector<std::vector<std::pair<int, double>>>& skin() const { return fine_skin_; }
  const std::vector<Segment>& segments() const { return segment_; }

 private:
  double scye_depth(const RestBody& rest) const;
  enum class Floor { under_the_feet, as_placed };
  BodyShape measured(RestBody rest) const;
  std::vector<Eigen::Affine3d> bones(const RestBody& rest, const Posture& posture) const;
  /// The body of a surface in rest posture, carried along by its bones.
  Body carry(const BodyShape& shape, const std::vector<Eigen::Affine3d>& bones, Floor floor) const;

  std::shared_ptr<const BodyData> data_;
  Morph morph_;
  CatmullClark subdivision_;
  std::vector<Triangle> coarse_triangles_;
  std::vector<std::vector<std::pair<int, double>>> fine_skin_;
  std::vector<Segment> segment_;
  std::vector<int> side_;
};

}  // namespace loosefit::body
