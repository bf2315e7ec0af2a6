#include "loosefit/drape/cloth_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::drape {
namespace {

/// Transverse stiffness of the fabric layer [Pa/m]: a pressure above those of clothing compresses
/// (docs/theory/contact.md 1) half the thickness; stiffer fabrics press harder in proportion.
double transverse_stiffness(const fabric::Material& m, const ClothModelTuning& tuning) {
  const double stiffest = std::max(m.stiffness_warp, m.stiffness_weft);
  return tuning.layer_pressure * std::max(1.0, stiffest / tuning.reference_stiffness) /
         (0.5 * m.thickness);
}

/// Explicit viscosity is stable only well below the time in which a wave crosses a triangle.
fabric::Material stable(fabric::Material m, const garment::Garment& garment,
                        const DrapeOptions& options) {
  if (options.integrator != IntegratorKind::semi_implicit_euler) return m;
  const double speed = std::sqrt(std::max(m.stiffness_warp, m.stiffness_weft) /
                                 ((1 - m.poisson * m.poisson) * m.areal_density));
  m.damping = std::min(m.damping, options.tuning.cloth.wave_share *
                                      geometry::shortest_height(garment.triangle_uv) / speed);
  return m;
}

contact::ContactLattice layer_lattice(const ClothMesh& mesh, int layer,
                                      const PenetrationTuning& tuning) {
  const std::vector<double> area(mesh.area.begin() + mesh.first_triangle[layer],
                                 mesh.area.begin() + mesh.first_triangle[layer + 1]);
  // Edges of an equilateral triangle of the mean area.
  double mean = 0;
  for (double a : area) mean += a / static_cast<double>(area.size());
  const double edge = std::sqrt(4 / std::sqrt(3.0) * mean);
  const int halves = std::max(1, static_cast<int>(std::ceil(0.5 * edge / tuning.lattice_spacing)));
  return {mesh.triangles_of(layer), area, mesh.first_vertex[layer],
          mesh.first_vertex[layer + 1] - mesh.first_vertex[layer], 2 * halves};
}

/// The corners of a layer as contact points, each with a third of the triangles that meet in it:
/// cloth between them lies no lower.
std::vector<contact::ContactPoint> corner_points(const ClothMesh& mesh, int layer, double offset) {
  const int first = mesh.first_vertex[layer];
  std::vector<contact::ContactPoint> points(mesh.first_vertex[layer + 1] - first);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].particle[0] = first + static_cast<int>(i);
    points[i].weight[0] = 1;
    points[i].offset = offset;
  }
  for (int t = mesh.first_triangle[layer]; t < mesh.first_triangle[layer + 1]; ++t)
    for (int v : mesh.triangles[t]) points[v - first].area += mesh.area[t] / 3;
  return points;
}

solver::Plate plate_of(const garment::Garment::RigidBoard& board, int first_vertex) {
  solver::Plate plate;
  for (int k = 0; k < 3; ++k) plate.leaders[k] = first_vertex + board.leaders[k];
  for (std::size_t i = 0; i < board.vertices.size(); ++i) {
    const int v = board.vertices[i];
    if (v == board.leaders[0] || v == board.leaders[1] || v == board.leaders[2]) continue;
    plate.followers.push_back(first_vertex + v);
    plate.weights.push_back(board.weights[i]);
  }
  return plate;
}

/// Per particle of all layers before and in this one: the most of its triangles [m]; empty:
/// nothing is padded.
std::vector<double> vertex_padding(const garment::Garment& garment, int first_vertex) {
  if (garment.triangle_padding.empty()) return {};
  std::vector<double> padding(first_vertex + garment.vertex_count, 0.0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int v : garment.triangles[t])
      padding[first_vertex + v] = std::max(padding[first_vertex + v], garment.triangle_padding[t]);
  return padding;
}

}  // namespace

Eigen::MatrixXd layer_friction(const std::vector<ModelLayer>& layers) {
  const auto n = static_cast<Eigen::Index>(layers.size());
  Eigen::MatrixXd friction(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      const fabric::Material &upper = layers[i].material, &lower = layers[j].material;
      const double mean = 0.5 * (upper.friction_self + lower.friction_self);
      friction(i, j) = friction(j, i) =
          i == j ? upper.friction_self : layers[j].friction_over.value_or(mean);
    }
  return friction;
}

ClothModel::ClothModel(const garment::Garment& garment, const fabric::Material& material,
                       const DrapeOptions& options, double self_thickness)
    : ClothModel({{&garment, material, self_thickness}}, options) {}

ClothModel::ClothModel(const std::vector<ModelLayer>& layers, const DrapeOptions& options) {
  const ClothModelTuning& tuning = options.tuning.cloth;
  // What holds for all layers, and one mesh of all garments.
  const Eigen::MatrixXd friction = layer_friction(layers);
  const bool viscous = options.integrator != IntegratorKind::quasi_static;
  std::vector<const garment::Garment*> garments;
  for (const ModelLayer& layer : layers) garments.push_back(layer.garment);
  mesh_ = joined(garments);
  contact::SelfContact::Options contact;
  std::vector<fabric::RigidPlate> boards;
  for (int l = 0; l < mesh_.layers(); ++l) {
    const garment::Garment& garment = *layers[l].garment;
    // Each layer stretches, bends and weighs as its own material says.
    const fabric::Material m = stable(layers[l].material, garment, options);
    const std::vector<Triangle> triangles = mesh_.triangles_of(l);
    membrane_.push_back(std::make_unique<fabric::MembraneEnergy>(
        triangles, garment.triangle_uv, garment.triangle_membrane_factor, m, viscous,
        garment.triangle_added_bending));
    bending_.push_back(std::make_unique<fabric::BendingEnergy>(triangles, garment.triangle_uv,
                                                               garment.triangle_added_bending, m,
                                                               viscous, garment.triangle_built_in));
    bands_.push_back(std::make_unique<fabric::BandEnergy>(triangles, garment.bands));
    system_.mass.insert(system_.mass.end(), garment.vertex_mass.begin(), garment.vertex_mass.end());
    for (int v = 0; v < garment.vertex_count; ++v)
      system_.cloth_mass.push_back(garment.cloth_mass(v));
    // Cloth keeps half its thickness from the skin.
    half_thickness_.push_back(0.5 * m.thickness);
    contact_stiffness_.push_back(transverse_stiffness(m, tuning));
    lattice_.push_back(layer_lattice(mesh_, l, options.tuning.penetrations));
    body_.push_back(std::make_unique<contact::BodyContact>(
        lattice_.back().first_points(half_thickness_.back()), contact_stiffness_.back(),
        m.friction_body, tuning.stick_reach));
    body_.back()->set_padding(vertex_padding(garment, mesh_.first_vertex[l]));
    for (const garment::Garment::RigidBoard& board : garment.rigid_boards) {
      system_.plates.push_back(plate_of(board, mesh_.first_vertex[l]));
      boards.push_back(
          {system_.plates.back().leaders, board.leader_uv, board.area, board.mass, board.offset});
    }
    floor_.push_back(std::make_unique<contact::BodyContact>(
        corner_points(mesh_, l, half_thickness_.back()), contact_stiffness_.back(), m.friction_body,
        tuning.stick_reach));
    under_soles_.push_back(layers[l].under_soles);
    // A single layer needs no thickness by triangle.
    if (mesh_.layers() > 1)
      contact.triangle_thickness.resize(mesh_.first_triangle[l + 1], layers[l].self_thickness);
  }
  // Gravity and contact of cloth with cloth see all layers at once.
  gravity_ = std::make_unique<particles::GravityEnergy>(system_.mass, options.gravity);
  boards_ = std::make_unique<fabric::BoardEnergy>(std::move(boards), options.gravity);
  load_ = std::make_unique<particles::DeadLoad>();
  contact.thickness = layers.front().self_thickness;
  contact.friction = friction(0, 0);
  if (mesh_.layers() > 1) {
    contact.triangle_layer = mesh_.triangle_layer;
    contact.layer_friction = friction;
  }
  contact.stick_reach = tuning.stick_reach;
  self_ =
      std::make_unique<contact::SelfContact>(mesh_.triangles, mesh_.area, mesh_.vertices, contact);
  // Forces are summed in this order, on which their last digits depend.
  for (const auto& e : membrane_) system_.energies.push_back(e.get());
  for (const auto& e : bending_) system_.energies.push_back(e.get());
  for (const auto& e : bands_)
    if (!e->empty()) system_.energies.push_back(e.get());
  if (!boards_->empty()) system_.energies.push_back(boards_.get());
  system_.energies.push_back(gravity_.get());
  system_.energies.push_back(load_.get());
  for (const auto& e : body_) system_.energies.push_back(e.get());
  for (const auto& e : floor_) system_.energies.push_back(e.get());
  system_.energies.push_back(self_.get());
  system_.gravity = options.gravity;
}

void ClothModel::soften_body_contact(double thickness) {
  for (int l = 0; l < mesh_.layers(); ++l) {
    const double offset = std::max(thickness, half_thickness_[l]);
    body_[l]->set_layer(offset, contact_stiffness_[l] * half_thickness_[l] / offset);
  }
}

void ClothModel::set_hardening(double share) {
  for (const auto* contacts : {&body_, &floor_})
    for (const auto& contact : *contacts) contact->set_hardening(share);
}

void ClothModel::set_friction_share(double share) {
  for (const auto* contacts : {&body_, &floor_})
    for (const auto& contact : *contacts) contact->set_friction_share(share);
  self_->set_friction_share(share);
}

void ClothModel::forget_anchors() {
  for (const auto* contacts : {&body_, &floor_})
    for (const auto& contact : *contacts) contact->forget_anchors();
  self_->forget_anchors();
}

ClothModel::Forces ClothModel::forces(const particles::VectorField& x) const {
  Forces forces;
  for (particles::VectorField& f : forces) f.assign(x.size(), Vec3::Zero());
  auto& [membrane, bending, gravity, body, self, body_friction, self_friction] = forces;
  for (const auto& e : membrane_) e->add_gradient(x, membrane);
  for (const auto& e : bands_) e->add_gradient(x, membrane);
  boards_->add_gradient(x, membrane);
  for (const auto& e : bending_) e->add_gradient(x, bending);
  gravity_->add_gradient(x, gravity);
  for (const auto* contacts : {&body_, &floor_})
    for (const auto& e : *contacts) {
      e->add_gradient(x, body);
      e->add_friction(x, body_friction);
    }
  self_->add_gradient(x, self);
  self_->add_friction(x, self_friction);
  for (std::size_t i = 0; i < x.size(); ++i) {
    body[i] -= body_friction[i];
    self[i] -= self_friction[i];
    for (particles::VectorField& f : forces) f[i] = -f[i];
  }
  return forces;
}

void ClothModel::set_body(const ContactBody& body) {
  floor_surface_ = body.floor;
  for (std::size_t l = 0; l < body_.size(); ++l) {
    body_[l]->set_field(body.field);
    floor_[l]->set_field(under_soles_[l] ? nullptr : body.floor);
  }
}

std::vector<int> ClothModel::below_floor(const particles::VectorField& x) const {
  std::vector<int> found;
  if (!floor_surface_) return found;
  for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t)
    if (!under_soles_[mesh_.triangle_layer[t]] &&
        std::ranges::any_of(mesh_.triangles[t],
                            [&](int v) { return x[v].z() < floor_surface_->height(); }))
      found.push_back(t);
  return found;
}

double ClothModel::floor_force(const particles::VectorField& x) const {
  std::vector<double> force(x.size(), 0.0);
  for (const auto& contact : floor_) contact->add_normal_force(x, force);
  return std::accumulate(force.begin(), force.end(), 0.0);
}

ClothMemory ClothModel::memory() const {
  ClothMemory memory{{}, {}, lattice_, self_->memory(), {}};
  for (const auto& contact : body_) memory.body.push_back(contact->memory());
  for (const auto& contact : floor_) memory.floor.push_back(contact->memory());
  for (const auto& bending : bending_) memory.bending.push_back(bending->memory());
  return memory;
}

void ClothModel::recall(const ClothMemory& memory) {
  for (std::size_t l = 0; l < body_.size(); ++l) {
    body_[l]->recall(memory.body[l]);
    floor_[l]->recall(memory.floor[l]);
    bending_[l]->recall(memory.bending[l]);
  }
  lattice_ = memory.lattice;
  self_->recall(memory.self);
}

}  // namespace loosefit::drape
