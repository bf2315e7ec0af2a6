#include "loosefit/body/lay_person.h"

#include "loosefit/body/skeleton_pose.h"

namespace loosefit::body {

LaidSkin lay(const BodyModel& model, const PosedPerson& person) {
  RestBody rest = model.rest(person.parameters);
  LaidSkin laid;
  const auto bones = pose_bones(model.data(), rest.joints, person.rotations);
  laid.maps = blend_bones(bones, model.skin());
  laid.triangles = std::move(rest.surface.triangles);
  laid.rest = std::move(rest.surface.vertices);
  for (std::size_t v = 0; v < laid.rest.size(); ++v)
    laid.surface.push_back(person.place * Vec3(laid.maps[v] * laid.rest[v].homogeneous()));
  for (std::size_t b = 0; b < bones.size(); ++b)
    laid.joints.push_back(person.place *
                          (bones[b] * rest.joints[std::size_t(model.data().bones[b].head)]));
  return laid;
}

}  // namespace loosefit::body
