#include "loosefit/contact/friction.h"

#include <algorithm>
#include <cmath>

namespace loosefit::contact {

Vec3 Friction::slide(const FrictionContact& c, const particles::VectorField& x) const {
  Vec3 u = c.offset;
  for (int k = 0; k < c.count; ++k) u += c.weight[k] * (x[c.particle[k]] - start_[c.particle[k]]);
  return u - c.normal * c.normal.dot(u);
}

void Friction::carry_anchors(std::vector<FrictionContact>& contacts,
                             const particles::VectorField& x, double reach) const {
  for (FrictionContact& c : contacts) {
    c.offset.setZero();
    const auto old =
        std::lower_bound(contacts_.begin(), contacts_.end(), c.key,
                         [](const FrictionContact& o, std::uint64_t key) { return o.key < key; });
    if (old == contacts_.end() || old->key != c.key) continue;
    Vec3 u = slide(*old, x);
    const double length = u.norm();
    if (length > reach) u *= reach / length;
    c.offset = u - c.normal * c.normal.dot(u);
  }
}

void Friction::restart(std::vector<FrictionContact> contacts, const particles::VectorField& x) {
  carry_anchors(contacts, x, reach_);
  contacts_ = std::move(contacts);
  set_active_set(nullptr);
  start_ = x;
  lagged_force_ = 0;
}

void Friction::set_active_set(const particles::ActiveSet* active_set) {
  active_contacts_ = particles::IndexSubset(contacts_.size());
  if (!active_set) return;
  active_contacts_ = particles::IndexSubset(contacts_.size(), [&](int i) {
    return active_set->touches(contacts_[i].particle, contacts_[i].count);
  });
}

void Friction::carry(const particles::VectorField& motion) {
  for (std::size_t i = 0; i < start_.size(); ++i) start_[i] += motion[i];
}

/// Takes a share of the change since `old`; returns what is left out [N].
double Friction::relax(FrictionContact& c, const FrictionContact& old, double normal_force) const {
  constexpr FrictionTuning kTuning = kContact.friction;
  c.change = normal_force - old.normal_force;
  c.relaxation =
      c.change * old.change < 0
          ? std::max(kTuning.min_relaxation, kTuning.relaxation_decrease * old.relaxation)
          : std::min(1.0, kTuning.relaxation_increase * old.relaxation);
  c.normal_force = c.relaxation == 1 ? normal_force : old.normal_force + c.relaxation * c.change;
  return coefficient_ * share_ * c.relative_friction * (normal_force - c.normal_force);
}

void Friction::iterate(std::vector<FrictionContact> contacts, const particles::VectorField& x) {
  std::vector<FrictionContact> all;
  all.reserve(contacts.size());
  double squared_lag = 0;
  std::size_t k = 0;
  for (const FrictionContact& old : contacts_) {
    while (k < contacts.size() && contacts[k].key < old.key) all.push_back(contacts[k++]);
    if (k < contacts.size() && contacts[k].key == old.key) {
      all.push_back(contacts[k]);
      squared_lag += std::pow(relax(all.back(), old, contacts[k++].normal_force), 2);
    } else if (old.lost < lost_iterations_) {
      all.push_back(old);
      ++all.back().lost;
      squared_lag += std::pow(relax(all.back(), old, 0), 2);
    }
  }
  all.insert(all.end(), contacts.begin() + static_cast<long>(k), contacts.end());
  carry_anchors(all, x, kContact.friction.memory * reach_);
  contacts_ = std::move(all);
  set_active_set(nullptr);
  start_ = x;
  lagged_force_ = std::sqrt(squared_lag);
}

double Friction::value(const particles::VectorField& x) const {
  double energy = 0;
  for (int i = 0; i < active_contacts_.size(); ++i) {
    const FrictionContact& c = contacts_[active_contacts_[i]];
    if (c.normal_force == 0) continue;
    const double s = slide(c, x).norm() / reach_;
    // Integral of s(2 − s) up to 1, then linear.
    const double f = s < 1 ? s * s * (1 - s / 3) : s - 1.0 / 3.0;
    energy += strength(c) * reach_ * f;
  }
  return energy;
}

double Friction::value_and_gradient(const particles::VectorField& x,
                                    particles::VectorField& g) const {
  double energy = 0;
  for (int i = 0; i < active_contacts_.size(); ++i) {
    const FrictionContact& c = contacts_[active_contacts_[i]];
    if (c.normal_force == 0) continue;
    const Vec3 u = slide(c, x);
    const double s = u.norm() / reach_;
    energy += strength(c) * reach_ * (s < 1 ? s * s * (1 - s / 3) : s - 1.0 / 3.0);
    const double per_length = s < 1 ? (2 - s) / reach_ : 1 / (s * reach_);  // f₀'/|u|
    const Vec3 force = strength(c) * per_length * u;
    for (int k = 0; k < c.count; ++k) g[c.particle[k]] += c.weight[k] * force;
  }
  return energy;
}

void Friction::add_pattern(particles::BlockPattern& pattern) const {
  for (const FrictionContact& c : contacts_) {
    if (c.normal_force == 0) continue;
    for (int a = 0; a < c.count; ++a)
      for (int b = 0; b < a; ++b) pattern.add(c.particle[a], c.particle[b]);
  }
}

void Friction::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h) const {
  for (int i = 0; i < active_contacts_.size(); ++i) {
    const FrictionContact& c = contacts_[active_contacts_[i]];
    if (c.normal_force == 0) continue;
    const Vec3 u = slide(c, x);
    const double length = u.norm(), s = length / reach_;
    const Mat3 plane = Mat3::Identity() - c.normal * c.normal.transpose();
    Mat3 stiffness = (s < 1 ? (2 - s) / reach_ : 1 / length) * plane;
    if (length > 0) {
      const Vec3 t = u / length;
      // d(f₀'/|u|)/d|u| · |u|: −s/reach inside, −1/|u| outside.
      stiffness -= (s < 1 ? s / reach_ : 1 / length) * t * t.transpose();
    }
    stiffness *= strength(c);
    for (int a = 0; a < c.count; ++a)
      for (int b = 0; b <= a; ++b)
        h.add(c.particle[a], c.particle[b], c.weight[a] * c.weight[b] * stiffness);
  }
}

}  // namespace loosefit::contact
