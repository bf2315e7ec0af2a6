#pragma once
#include <memory>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_partner.h"
#include "loosefit/body/regions.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {

/// A body in one posture with the index of its surface: what drape, maps and placement ask of it.
/// Each part of the index is made when it is first asked for and kept. A handle: copies are cheap
/// and share body and index; the body does not change. Safe to ask from several threads.
///
/// References that it gives live as long as any copy of it.
class PosedBody {
 public:
  /// Implicit, so that a body may stand wherever a posed body is asked for; its index is then made
  /// for that one use.
  PosedBody(Body body = {});  // NOLINT(google-explicit-constructor)
  explicit PosedBody(std::shared_ptr<const Body> body);

  const Body& body() const;
  const Body* operator->() const { return &body(); }
  operator const Body&() const { return body(); }  // NOLINT(google-explicit-constructor)

  /// Closest points, signed distances and overlaps of the skin.
  const geometry::ClosestPointTree& tree() const;
  /// \throws InvalidInput for a body without a segment, side or normal for every vertex.
  const PartnerFinder& partners() const;
  /// segment_axes of the body.
  const std::vector<Vec3>& axes() const;
  /// body_regions of the body.
  const std::vector<Region>& regions() const;

 private:
  friend class RememberedBody;
  struct Index;
  std::shared_ptr<const Index> index_;
};

/// A posed body to come back to: keeps the body itself, and its index as long as somebody else
/// holds it. An index weighs more than its body.
class RememberedBody {
 public:
  explicit RememberedBody(const PosedBody& posed);
  /// With the index that is in use, if there is one. One caller at a time.
  PosedBody posed();

 private:
  std::shared_ptr<const Body> body_;
  std::weak_ptr<const PosedBody::Index> index_;
};

}  // namespace loosefit::body
