#include "loosefit/contact/self_contact.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"

namespace loosefit::contact {
namespace {

template <class F>
void for_each_index(std::size_t n, std::size_t grain, F f) {
  if (n <= grain) {
    for (std::size_t i = 0; i < n; ++i) f(i);
    return;
  }
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, n, grain), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) f(i);
  });
}

double largest_friction(const SelfContact::Options& o) {
  const auto& m = o.layer_friction;
  if (m.size() == 0) return o.friction;
  int layers = 1;
  for (int l : o.triangle_layer) layers = std::max(layers, l + 1);
  if (m.rows() != m.cols() || m.rows() < layers || m != m.transpose() || m.minCoeff() < 0)
    throw InvalidInput(InputPlace{"", 0, "layer_friction"},
                       std::to_string(m.rows()) + " x " + std::to_string(m.cols()) + " numbers",
                       "a symmetric matrix without negative numbers, a row for each of " +
                           std::to_string(layers) + " layers");
  return m.maxCoeff();
}

}  // namespace

SelfContact::SelfContact(const std::vector<Triangle>& triangles,
                         const std::vector<double>& triangle_area, int particles,
                         const Options& options)
    : options_(options),
      candidates_(ContactFeatures(triangles, triangle_area, particles, options.thickness,
                                  options.triangle_thickness, options.triangle_layer, options.rest),
                  options.list_margin),
      friction_(largest_friction(options), options.stick_reach, kContact.friction.lost_iterations),
      blocks_(particles) {}

double SelfContact::friction_between(const FeaturePair& pair) const {
  if (options_.layer_friction.size() == 0) return options_.friction;
  const ContactFeatures& f = candidates_.features();
  return pair.kind == PairKind::point_triangle
             ? options_.layer_friction(f.of_vertex[pair.first].layer,
                                       f.of_triangle[pair.second].layer)
             : options_.layer_friction(f.of_edge[pair.first].layer, f.of_edge[pair.second].layer);
}

void SelfContact::take_pairs(const std::vector<FeaturePair>& near,
                             const particles::VectorField& x) {
  const ContactFeatures& f = candidates_.features();
  pairs_.resize(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    BarrierPair& pair = pairs_[i];
    static_cast<FeaturePair&>(pair) = near[i];
    if (pair.kind == PairKind::point_triangle) {
      pair.scale = options_.pressure * f.of_vertex[pair.first].area;
      continue;
    }
    const double area = 0.5 * (f.of_edge[pair.first].area + f.of_edge[pair.second].area);
    pair.scale = options_.pressure * area;
    const PairPoints p = pair.points(x);
    pair.parallel_threshold = kContact.barrier.parallel_threshold * (p[1] - p[0]).squaredNorm() *
                              (p[3] - p[2]).squaredNorm();
  }
}

void SelfContact::set_active_set(const particles::ActiveSet* active_set) {
  candidates_.set_active_set(active_set);
  friction_.set_active_set(active_set);
  restricted_ = active_set != nullptr;
  if (!frozen_pairs_.empty()) {
    const auto middle = static_cast<long>(pairs_.size());
    pairs_.insert(pairs_.end(), frozen_pairs_.begin(), frozen_pairs_.end());
    std::inplace_merge(
        pairs_.begin(), pairs_.begin() + middle, pairs_.end(),
        [](const BarrierPair& a, const BarrierPair& b) { return a.key() < b.key(); });
    frozen_pairs_.clear();
  }
  if (!active_set) return;
  const auto split = std::stable_partition(pairs_.begin(), pairs_.end(), [&](const BarrierPair& p) {
    return active_set->touches(p.particle, 4);
  });
  frozen_pairs_.assign(split, pairs_.end());
  pairs_.erase(split, pairs_.end());
}

double SelfContact::max_step(const particles::VectorField& x, const particles::VectorField& dx) {
  take_pairs(candidates_.approaching(x, dx), x);
  ++searches_;
  share_.resize(pairs_.size());
  for_each_index(pairs_.size(), 64, [&](std::size_t i) {
    share_[i] = time_of_impact(pairs_[i].kind, pairs_[i].points(x), pairs_[i].points(dx));
  });
  double largest = 1.0;
  for (double s : share_) largest = std::min(largest, s);
  return largest;
}

/// Fills barrier_ and active_ (indices of the pairs in contact, rising).
void SelfContact::evaluate(const particles::VectorField& x) const {
  barrier_.resize(pairs_.size());
  for_each_index(pairs_.size(), 256, [&](std::size_t i) {
    barrier_[i] = evaluate_barrier(pairs_[i], pairs_[i].points(x));
  });
  active_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (barrier_[i].active) active_.push_back(static_cast<int>(i));
}

void SelfContact::recall(const Memory& memory) {
  LOOSEFIT_ASSERT(
      std::all_of(memory.pairs.begin(), memory.pairs.end(), [&](const FeaturePair& pair) {
        const ContactFeatures& mesh = candidates_.features();
        const bool edges = pair.kind == PairKind::edge_edge;
        return pair.first < static_cast<int>(edges ? mesh.edges.size() : mesh.of_vertex.size()) &&
               pair.second < static_cast<int>(edges ? mesh.edges.size() : mesh.triangles.size());
      }));
  pairs_ = memory.pairs;
  friction_.recall(memory.friction);
  blocks_.recall(memory.blocks);
}

void SelfContact::begin_step(const particles::VectorField& x, double dt) {
  take_pairs(candidates_.touching(x), x);
  if (friction_.coefficient() <= 0) return;
  evaluate(x);
  std::vector<FrictionContact> contacts;
  contacts.reserve(active_.size());
  for (int i : active_) {
    const Barrier& b = barrier_[i];
    if (!(b.d.distance > 0)) continue;
    FrictionContact c;
    c.key = pairs_[i].key();
    c.particle = pairs_[i].particle;
    c.weight = b.d.weight;
    c.count = 4;
    c.normal = b.d.normal;
    c.normal_force = -b.slope;
    c.relative_friction = friction_between(pairs_[i]) / friction_.coefficient();
    contacts.push_back(c);
  }
  // The pairs, and so the contacts, are sorted by key.
  if (std::isfinite(dt))
    friction_.restart(std::move(contacts), x);
  else
    friction_.iterate(std::move(contacts), x);
}

double SelfContact::value(const particles::VectorField& x) const {
  evaluate(x);
  double energy = 0;
  for (int i : active_) energy += barrier_[i].energy;
  return energy + friction_.value(x);
}

double SelfContact::value_and_gradient(const particles::VectorField& x,
                                       particles::VectorField& g) const {
  evaluate(x);
  force_.resize(active_.size());
  for_each_index(active_.size(), 256, [&](std::size_t k) {
    const BarrierPair& pair = pairs_[active_[k]];
    force_[k] = barrier_gradient(pair, pair.points(x), barrier_[active_[k]]);
  });
  double energy = 0;
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const BarrierPair& pair = pairs_[active_[k]];
    energy += barrier_[active_[k]].energy;
    for (int j = 0; j < 4; ++j) g[pair.particle[j]] += force_[k][j];
  }
  return energy + friction_.value_and_gradient(x, g);
}

void SelfContact::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  value_and_gradient(x, g);
}

void SelfContact::remember(const particles::VectorField& x) const {
  evaluate(x);
  blocks_.begin();
  for (int i : active_) blocks_.use(pairs_[i].particle, 4);
  for (const FrictionContact& c : friction_.contacts())
    if (c.normal_force > 0) blocks_.use(c.particle, c.count);
  blocks_.end(!restricted_);
}

void SelfContact::add_pattern(const particles::VectorField& x,
                              particles::BlockPattern& pattern) const {
  remember(x);
  blocks_.add_to(pattern);
}

std::uint64_t SelfContact::pattern_version(const particles::VectorField& x) const {
  remember(x);
  return blocks_.version();
}

void SelfContact::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                              particles::HessianKind kind) const {
  evaluate(x);
  constexpr std::size_t kBatch = 1024;  // bounds the memory
  for (std::size_t from = 0; from < active_.size(); from += kBatch) {
    const std::size_t n = std::min(kBatch, active_.size() - from);
    stiffness_.resize(kBatch);
    for_each_index(n, 32, [&](std::size_t k) {
      const int i = active_[from + k];
      stiffness_[k] = barrier_hessian(pairs_[i], pairs_[i].points(x), barrier_[i], kind);
    });
    for (std::size_t k = 0; k < n; ++k) {
      const auto& p = pairs_[active_[from + k]].particle;
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b) h.add(p[a], p[b], stiffness_[k].block<3, 3>(3 * a, 3 * b));
    }
  }
  friction_.add_hessian(x, h);
}

int SelfContact::active(const particles::VectorField& x) const {
  evaluate(x);
  return static_cast<int>(active_.size());
}

}  // namespace loosefit::contact
