#include "loosefit/body/posed_body.h"

#include <utility>

#include "loosefit/base/lazy.h"
#include "loosefit/body/body_frame.h"

namespace loosefit::body {

struct PosedBody::Index {
  std::shared_ptr<const Body> body;
  Lazy<geometry::ClosestPointTree> tree;
  Lazy<PartnerFinder> partners;
  Lazy<std::vector<Vec3>> axes;
  Lazy<std::vector<Region>> regions;
};

PosedBody::PosedBody(Body body) : PosedBody(std::make_shared<const Body>(std::move(body))) {}

PosedBody::PosedBody(std::shared_ptr<const Body> body) {
  auto index = std::make_shared<Index>();
  index->body = std::move(body);
  index_ = std::move(index);
}

const Body& PosedBody::body() const { return *index_->body; }

const geometry::ClosestPointTree& PosedBody::tree() const {
  return index_->tree.get([&] { return geometry::ClosestPointTree(body().surface); });
}

const PartnerFinder& PosedBody::partners() const {
  return index_->partners.get([&] { return PartnerFinder(body(), tree()); });
}

const std::vector<Vec3>& PosedBody::axes() const {
  return index_->axes.get([&] { return segment_axes(body()); });
}

const std::vector<Region>& PosedBody::regions() const {
  return index_->regions.get([&] { return body_regions(body()); });
}

RememberedBody::RememberedBody(const PosedBody& posed)
    : body_(posed.index_->body), index_(posed.index_) {}

PosedBody RememberedBody::posed() {
  PosedBody posed(body_);
  if (auto index = index_.lock())
    posed.index_ = std::move(index);
  else
    index_ = posed.index_;
  return posed;
}

}  // namespace loosefit::body
