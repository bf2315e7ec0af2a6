#include "loosefit/drape/cloth_model.h"

#include <algorithm>
#include <cmath>

namespace loosefit {
namespace {

/// Transverse stiffness of the fabric layer [Pa/m]: 5 kPa, above the pressures of clothing
/// (patterns.md 7), compress half the thickness; stiffer fabrics press harder in proportion.
double layer_stiffness(const Material& m) {
  constexpr double kPressure = 5000, kReferenceStiffness = 2000;
  const double stiffest = std::max(m.stiffness_warp, m.stiffness_weft);
  return kPressure * std::max(1.0, stiffest / kReferenceStiffness) / (0.5 * m.thickness);
}

double shortest_height(const Garment& g) {
  double least = 1e9;
  for (const auto& [a, b, c] : g.triangle_uv) {
    const double twice = std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]);
    least = std::min(least, twice / std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}));
  }
  return least;
}

}  // namespace

std::vector<double> flat_areas(const Garment& garment) {
  std::vector<double> area;
  for (const auto& [a, b, c] : garment.triangle_uv)
    area.push_back(0.5 * std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]));
  return area;
}

ClothModel::ClothModel(const Garment& garment, const Material& material,
                       const DrapeOptions& options, double self_thickness) {
  Material m = material;
  if (options.integrator == IntegratorKind::semi_implicit_euler) {
    // Explicit viscosity is stable only well below the time in which a wave crosses a triangle.
    const double speed = std::sqrt(std::max(m.stiffness_warp, m.stiffness_weft) /
                                   ((1 - m.poisson * m.poisson) * m.areal_density));
    m.damping = std::min(m.damping, 0.1 * shortest_height(garment) / speed);
  }
  const bool viscous = options.integrator != IntegratorKind::quasi_static;
  membrane_ = std::make_unique<MembraneEnergy>(garment.triangles, garment.triangle_uv,
                                               garment.triangle_membrane_factor, m, viscous);
  bending_ = std::make_unique<BendingEnergy>(garment.triangles, garment.triangle_uv,
                                             garment.triangle_added_bending, m, viscous,
                                             garment.triangle_built_in);
  gravity_ = std::make_unique<GravityEnergy>(garment.vertex_mass, options.gravity);
  const auto area = flat_areas(garment);
  half_thickness_ = 0.5 * m.thickness;
  layer_stiffness_ = layer_stiffness(m);
  body_ = std::make_unique<BodyContact>(
      contact_points(garment.triangles, area, garment.vertex_count, half_thickness_),
      layer_stiffness_, m.friction_body, kStickReach);
  SelfContact::Options contact;
  contact.thickness = self_thickness;
  contact.friction = m.friction_self;
  contact.stick_reach = kStickReach;
  self_ = std::make_unique<SelfContact>(garment.triangles, area, garment.vertex_count, contact);
  system_.energies = {membrane_.get(), bending_.get(), gravity_.get(), body_.get(), self_.get()};
  system_.mass = garment.vertex_mass;
  system_.gravity = options.gravity;
}

void ClothModel::pad_body(double thickness) {
  const double offset = std::max(thickness, half_thickness_);
  body_->set_layer(offset, layer_stiffness_ * half_thickness_ / offset);
}

ClothModel::Forces ClothModel::forces(const VectorField& x) const {
  Forces forces;
  for (VectorField& f : forces) f.assign(x.size(), Vec3::Zero());
  auto& [membrane, bending, gravity, body, self, body_friction, self_friction] = forces;
  membrane_->add_gradient(x, membrane);
  bending_->add_gradient(x, bending);
  gravity_->add_gradient(x, gravity);
  body_->add_gradient(x, body);
  self_->add_gradient(x, self);
  body_->add_friction(x, body_friction);
  self_->add_friction(x, self_friction);
  for (std::size_t i = 0; i < x.size(); ++i) {
    body[i] -= body_friction[i];
    self[i] -= self_friction[i];
    for (VectorField& f : forces) f[i] = -f[i];
  }
  return forces;
}

void ClothModel::recall(const ClothMemory& memory) {
  *body_ = memory.body;
  *self_ = memory.self;
  bending_->recall(memory.bending);
}

}  // namespace loosefit
