#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/body/body_model.h"
#include "loosefit/body/posed_body.h"
#include "loosefit/flesh/skin_patch.h"

namespace loosefit::flesh {

/// Largest angle by which a joint turns from one posture to the other [rad].
double turn_between(const body::Posture& a, const body::Posture& b);

/// Pairs of triangles that pass through each other, sorted.
using Overlaps = std::vector<std::pair<int, int>>;

/// Those of the skin that a garment can get between: trunk, neck, arms, thighs.
Overlaps overlaps_of(const body::Body& body);

/// The body with its skin moved by so much at every vertex [m]; pose_from_rest tells the same
/// place.
body::Body displaced(body::Body body, const std::vector<Vec3>& moved);

/// One person in any posture, with flesh that gives way where BodyModel::build pushes skin through
/// skin: armpits of arms that hang close, groins and bellies of people who sit. There the skin is
/// led from a posture in which nothing overlaps as an elastic surface on an elastic foundation
/// whose folds repel each other (SoftSkin), so it folds without passing through itself and leaves
/// room for cloth, up to body::kSkinGap. It holds for trunk, arms and thighs; hands, shanks and the
/// head stay as built. One caller at a time; a copy is for another one.
class SoftBody {
 public:
  /// The model has to outlive this.
  SoftBody(const body::BodyModel& model, body::BodyParameters parameters)
      : model_(model), parameters_(std::move(parameters)) {}

  /// As BodyModel::build; the displacement joins body.pose_from_rest, so that both still tell the
  /// same place. Skin without overlaps is left as it is, bit for bit. The way there starts from
  /// the rest posture or the nearest one that was asked for before, so the shape depends a little
  /// on the order of questions; asked again, it is the same. The disk cache keeps each way, by its
  /// start and its end. `progress` hears of the way there, if there is one. \throws as
  /// BodyModel::build, Cancelled.
  body::PosedBody in(const body::Posture& posture, Progress* progress = nullptr);

  /// Pairs of triangles of this person's skin in some posture that pass through each other, though
  /// flesh has given way: none in most, as none of trunk, arms and thighs may; those of creases
  /// that are there at rest are left out.
  Overlaps left_in(const body::Body& posed);

  /// As BodyModel::build: flesh has not given way.
  body::Body as_built(const body::Posture& posture) const { return model_.posed(shape(), posture); }
  /// The vertices of its surface.
  std::vector<Vec3> built(const body::Posture& posture) const {
    return model_.vertices(shape(), posture);
  }

  const body::BodyParameters& parameters() const { return parameters_; }

  /// The same person, not asked anything yet.
  SoftBody without_cache() const {
    SoftBody person(model_, parameters_);
    person.shape_ = shape_;
    return person;
  }

  /// Takes over what a copy of this has been asked since, so that it need not be made again.
  void merge_cache(const SoftBody& copy);

 private:
  body::Body made(const body::Posture& posture, Progress* progress);
  /// Where the skin is in a posture when flesh has given way: sparse, the rest is as built.
  struct CachedDisplacement {
    body::Posture posture;
    std::vector<int> vertex;
    std::vector<Vec3> moved;  ///< of these vertices [m]
  };
  const CachedDisplacement& nearest(const body::Posture& posture);
  /// The way to a body that is not as built; without vertices where nothing overlaps there.
  struct Way {
    CachedDisplacement there;
    bool is_free = false;
  };
  Way led_to(const body::Posture& posture, const body::Body& stiff, Progress* progress);
  static std::string written(const Way& way);
  static std::optional<Way> read_way(const std::string& bytes, const body::Posture& posture);
  std::string key_of(const body::Posture& posture, const body::Body& stiff,
                     const CachedDisplacement& start) const;
  CachedDisplacement led_from(const CachedDisplacement& start, const body::Posture& posture,
                              const body::Body& body, const SkinPatch& patch,
                              Progress* progress) const;
  static body::Body moved(body::Body body, const CachedDisplacement& cached);
  const body::BodyShape& shape() const;
  /// Whether nothing overlaps but what does at rest, which no way from there can part.
  bool is_free(const Overlaps& overlaps);
  const std::set<std::pair<int, int>>& overlaps_at_rest();

  const body::BodyModel& model_;
  body::BodyParameters parameters_;
  /// Made when it is first asked for; copies of this share it.
  mutable std::shared_ptr<const body::BodyShape> shape_;
  std::vector<Vec3> rest_;  ///< surface in the rest posture [m]
  /// There, in creases that the shape of the body itself folds: shoulders of the old, for one.
  std::optional<std::set<std::pair<int, int>>> overlaps_at_rest_;
  /// Without overlaps but for those at rest; the first is the rest posture.
  std::vector<CachedDisplacement> cached_;
  /// The first answers: donnings follow each other through the same postures.
  std::vector<std::pair<body::Posture, body::RememberedBody>> remembered_;
};

}  // namespace loosefit::flesh
