#include "loosefit/contact/body_contact.h"

#include <algorithm>
#include <cmath>

#include "loosefit/contact/contact_tuning.h"
#include "loosefit/contact/distance_field.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/particles/tile.h"

namespace loosefit::contact {

std::vector<ContactPoint> contact_points(const std::vector<Triangle>& triangles,
                                         const std::vector<double>& triangle_area, int particles,
                                         double offset) {
  std::vector<ContactPoint> points(particles);
  for (int i = 0; i < particles; ++i) {
    points[i].particle[0] = i;
    points[i].weight[0] = 1;
    points[i].offset = offset;
  }
  const geometry::MeshTopology topology(triangles);
  std::vector<double> edge_area(topology.edge_count(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      points[triangles[t][k]].area += triangle_area[t] / 12;
      edge_area[topology.edge(static_cast<int>(t), k)] += triangle_area[t] / 4;
    }
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto& [low, high] = topology.edges()[e];
    ContactPoint p;
    p.particle = {low, high, 0};
    p.weight = {0.5, 0.5, 0};
    p.count = 2;
    p.area = edge_area[e];
    p.offset = offset;
    points.push_back(p);
  }
  return points;
}

bool ContactPoint::within(const Triangle& t) const {
  for (int k = 0; k < count; ++k)
    if (particle[k] != t[0] && particle[k] != t[1] && particle[k] != t[2]) return false;
  return true;
}

BodyContact::BodyContact(std::vector<ContactPoint> points, double stiffness, double friction,
                         double stick_reach)
    : points_(std::move(points)), stiffness_(stiffness), friction_(friction, stick_reach) {}

void BodyContact::set_active_set(const particles::ActiveSet* active_set) {
  evaluated_at_.clear();
  friction_.set_active_set(active_set);
  restricted_ = active_set != nullptr;
  if (!active_set) return;
  active_ = particles::IndexSubset(points_.size(), [&](int i) {
    return active_set->touches(points_[i].particle, points_[i].count);
  });
}

Vec3 ContactPoint::position(const particles::VectorField& x) const {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < count; ++k) sum += weight[k] * x[particle[k]];
  return sum;
}

LayerResponse compress_layer(double k, double offset, double compression, double hardening) {
  LayerResponse r;
  const double d = compression, onset = kContact.layer.onset * offset;
  r.energy = 0.5 * k * d * d;
  r.pressure = k * d;
  r.stiffness = k;
  if (d <= onset || hardening <= 0) return r;
  // u²/w³ with the part w of the remaining layer L that is left: ∞ where nothing is.
  const double h = hardening * kContact.layer.hardening * k / offset;
  const double rest = offset - onset, u = std::min(d, kContact.layer.hardest * offset) - onset;
  const double w = 1 - u / rest;
  const double pressure = h * u * u / (w * w * w);
  const double slope = h * (2 * u + 3 * u * u / (rest * w)) / (w * w * w);
  const double beyond = std::max(0.0, d - kContact.layer.hardest * offset);
  r.energy += h * rest * rest * rest * (0.5 / (w * w) - 2 / w + 1.5 - std::log(w)) +
              beyond * (pressure + 0.5 * slope * beyond);
  r.pressure += pressure + slope * beyond;
  r.stiffness += slope;
  return r;
}

double BodyContact::field_distance(const ContactPoint& point, const particles::VectorField& x,
                                   double reach) const {
  ContactSurface::Sample sample;
  return field_->sample(point.position(x), reach, false, sample) ? sample.distance : reach;
}

double BodyContact::padding_of(const ContactPoint& point) const {
  if (padding_.empty()) return 0;
  double least = padding_[point.particle[0]];
  for (int k = 1; k < point.count; ++k) least = std::min(least, padding_[point.particle[k]]);
  return least;
}

BodyContact::Touch BodyContact::ask(std::size_t i, const particles::VectorField& x,
                                    bool with_hessian) const {
  Touch touch;
  const Vec3 p = points_[i].position(x);
  Clear& clear = clear_[i];
  if (clear.slack > 0 && (p - clear.position).squaredNorm() < clear.slack * clear.slack)
    return touch;
  const double taken_off = points_[i].field_error + padding_of(points_[i]);
  const double reach = points_[i].offset + taken_off;
  touch.active = field_->sample(p, reach, with_hessian, touch.sample);
  clear = {p, touch.active ? -1 : (touch.sample.distance - reach) / DistanceField::kSteepest};
  touch.sample.distance -= taken_off;
  return touch;
}

const std::vector<BodyContact::Touch>& BodyContact::touches(const particles::VectorField& x,
                                                            bool with_hessian) const {
  if (!field_) {
    touch_.assign(points_.size(), {});
    return touch_;
  }
  if (evaluated_at_ == x && (with_hessian_ || !with_hessian)) return touch_;
  touch_.resize(points_.size());
  clear_.resize(points_.size());
  particles::for_ranges(point_count(), 256, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) touch_[point_index(k)] = ask(point_index(k), x, with_hessian);
  });
  evaluated_at_ = x;
  with_hessian_ = with_hessian;
  return touch_;
}

void BodyContact::begin_step(const particles::VectorField& x, double dt) {
  if (friction_.coefficient() <= 0) return;
  std::vector<FrictionContact> contacts;
  const auto& touch = touches(x, false);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!touch[i].active) continue;
    const ContactPoint& p = points_[i];
    FrictionContact c;
    c.key = i;
    c.count = p.count;
    for (int k = 0; k < p.count; ++k) {
      c.particle[k] = p.particle[k];
      c.weight[k] = p.weight[k];
    }
    const double slope = touch[i].sample.gradient.norm();
    if (!(slope > 0)) continue;
    c.normal = touch[i].sample.gradient / slope;
    c.normal_force = p.area * slope * layer(p, touch[i]).pressure;
    contacts.push_back(c);
  }
  if (std::isfinite(dt))
    friction_.restart(std::move(contacts), x);
  else
    friction_.iterate(std::move(contacts), x);
}

double BodyContact::value(const particles::VectorField& x) const {
  double energy = 0;
  const auto& touch = touches(x, false);
  for (int n = 0; n < point_count(); ++n)
    if (const int i = point_index(n); touch[i].active)
      energy += points_[i].area * layer(points_[i], touch[i]).energy;
  return energy + friction_.value(x);
}

double BodyContact::value_and_gradient(const particles::VectorField& x,
                                       particles::VectorField& g) const {
  const auto& touch = touches(x, false);
  double energy = 0;
  for (int n = 0; n < point_count(); ++n)
    if (const int i = point_index(n); touch[i].active) {
      const ContactPoint& p = points_[i];
      const LayerResponse response = layer(p, touch[i]);
      energy += p.area * response.energy;
      const Vec3 force = -p.area * response.pressure * touch[i].sample.gradient;
      for (int k = 0; k < p.count; ++k) g[p.particle[k]] += p.weight[k] * force;
    }
  return energy + friction_.value_and_gradient(x, g);
}

void BodyContact::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  value_and_gradient(x, g);
}

void BodyContact::add_pattern(const particles::VectorField&,
                              particles::BlockPattern& pattern) const {
  for (const ContactPoint& p : points_)
    for (int a = 0; a < p.count; ++a)
      for (int b = 0; b < a; ++b) pattern.add(p.particle[a], p.particle[b]);
}

void BodyContact::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                              particles::HessianKind kind) const {
  const bool exact = kind == particles::HessianKind::exact;
  const auto& touch = touches(x, exact);
  for (int n = 0; n < point_count(); ++n) {
    const int i = point_index(n);
    if (!touch[i].active) continue;
    const ContactPoint& p = points_[i];
    const auto& s = touch[i].sample;
    const LayerResponse response = layer(p, touch[i]);
    Mat3 block = response.stiffness * p.area * s.gradient * s.gradient.transpose();
    if (exact) block -= response.pressure * p.area * s.hessian;
    for (int a = 0; a < p.count; ++a)
      for (int b = 0; b <= a; ++b)
        h.add(p.particle[a], p.particle[b], p.weight[a] * p.weight[b] * block);
  }
  friction_.add_hessian(x, h);
}

void BodyContact::add_normal_force(const particles::VectorField& x, std::vector<double>& f) const {
  const auto& touch = touches(x, false);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (touch[i].active) {
      const ContactPoint& p = points_[i];
      const double force = p.area * layer(p, touch[i]).pressure * touch[i].sample.gradient.norm();
      for (int k = 0; k < p.count; ++k) f[p.particle[k]] += p.weight[k] * force;
    }
}

int BodyContact::active(const particles::VectorField& x) const {
  int count = 0;
  for (const Touch& t : touches(x, false)) count += t.active;
  return count;
}

std::vector<int> BodyContact::bearing(const particles::VectorField& x) const {
  const auto& touch = touches(x, false);
  std::vector<int> found;
  for (std::size_t i = 0; i < touch.size(); ++i)
    if (touch[i].active) found.push_back(static_cast<int>(i));
  return found;
}

}  // namespace loosefit::contact
