#include "loosefit/body/posed_body.h"

#include <utility>

#include "loosefit/base/lazy.h"
#include "loosefit/body/body_frame.h"

namespace loosefit {

struct PosedBody::Index {
  Body body;
  Lazy<ClosestPointTree> tree;
  Lazy<PartnerFinder> partners;
  Lazy<std::vector<Vec3>> axes;
  Lazy<std::vector<Region>> regions;
};

PosedBody::PosedBody(Body body) {
  auto index = std::make_shared<Index>();
  index->body = std::move(body);
  index_ = std::move(index);
}

const Body& PosedBody::body() const { return index_->body; }

const ClosestPointTree& PosedBody::tree() const {
  return index_->tree.get([&] { return ClosestPointTree(body().surface); });
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

}  // namespace loosefit
