#include <gtest/gtest.h>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/solver/quasi_static.h"
#include "support/simple_patterns.h"

namespace loosefit::drape {
namespace {

/// A strip of cloth along +u with a band on its middle line, held at u = 0.
struct Banded {
  static constexpr double kLength = 0.30, kWidth = 0.04;
  garment::GarmentHierarchy hierarchy;
  fabric::Material material;
  std::vector<Vec3> x;
  std::unique_ptr<ClothModel> model;

  Banded(double axial_stiffness, double pre_stretch) {
    material.stiffness_warp = material.stiffness_weft = 100;
    material.stiffness_shear = 50;
    material.poisson = 0;
    garment::Cable cable;
    cable.path = {{0, kWidth / 2}, {kLength, kWidth / 2}};
    cable.width = kWidth;
    cable.axial_stiffness = axial_stiffness;
    cable.pre_stretch = pre_stretch;
    pattern::Pattern p;
    p.panels = {testing_support::rectangle_panel("strip", kLength, kWidth)};
    hierarchy = garment::build_hierarchy(p, 0.01, material, {{"band", "strip", cable}});
    DrapeOptions options;
    options.gravity = 0;
    model = std::make_unique<ClothModel>(hierarchy.finest(), material, options, 2e-4);
    for (const Vec2& uv : hierarchy.finest().vertex_uv) x.emplace_back(uv.x(), uv.y(), 0);
  }

  /// Pulls at its free end with that force [N] and lets it come to rest; how much longer it is [m].
  double pulled(double force) {
    solver::ParticleSystem& system = model->system();
    system.held.assign(x.size(), 0);
    particles::VectorField load(x.size(), Vec3::Zero());
    std::vector<int> end;
    for (std::size_t v = 0; v < x.size(); ++v) {
      const Vec2& uv = hierarchy.finest().vertex_uv[v];
      if (uv.x() < 1e-9) system.held[v] = 1;
      if (uv.x() > kLength - 1e-9) end.push_back(static_cast<int>(v));
    }
    // Half as much at the corners, as for an even traction.
    double share = 0;
    const auto weight = [&](int v) {
      const double y = hierarchy.finest().vertex_uv[v].y();
      return y < 1e-9 || y > kWidth - 1e-9 ? 0.5 : 1.0;
    };
    for (const int v : end) share += weight(v);
    for (const int v : end) load[v] = force * weight(v) / share * Vec3::UnitX();
    model->set_load(load);
    system.gravity = kGravity;  // residuals refer to the weight
    solver::SettleOptions options;
    options.tolerance = 1e-7;
    EXPECT_EQ(solver::make_quasi_static(system)->settle(x, options).reason,
              solver::SettleOutcome::Reason::converged);
    double longer = 0;
    for (const int v : end) longer += (x[v].x() - kLength) / static_cast<double>(end.size());
    return longer;
  }
};

/// Force of the strip of cloth and of the band at an elongation of the cloth [N].
double force_at(double e, double axial_stiffness, double pre_stretch) {
  const double green = e + e * e / 2;
  return Banded::kWidth * 100 * green * (1 + e) +
         axial_stiffness * fabric::band_law((1 + pre_stretch) * (1 + e) - 1).force;
}

TEST(Band, ActsAsASpringBesideTheStripOnWhichItIsSewn) {
  for (const double axial : {0.0, 4.0, 20.0}) {
    Banded strip(axial, 0);
    const double e = strip.pulled(0.5) / Banded::kLength;
    EXPECT_NEAR(force_at(e, axial, 0), 0.5, 0.005) << axial;
  }
}

TEST(Band, ThatCoversHalfTheStripIsInSeriesWithTheOtherHalf) {
  // Two springs in series: the half with the band and the bare half.
  Banded strip(20, 0);
  garment::Cable half;
  half.path = {{0, Banded::kWidth / 2}, {Banded::kLength / 2, Banded::kWidth / 2}};
  half.width = Banded::kWidth;
  half.axial_stiffness = 20;
  pattern::Pattern p;
  p.panels = {testing_support::rectangle_panel("strip", Banded::kLength, Banded::kWidth)};
  strip.hierarchy = garment::build_hierarchy(p, 0.01, strip.material, {{"band", "strip", half}});
  DrapeOptions options;
  options.gravity = 0;
  strip.model =
      std::make_unique<ClothModel>(strip.hierarchy.finest(), strip.material, options, 2e-4);
  const double longer = strip.pulled(0.5);
  const auto elongation = [](double axial) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (force_at(middle, axial, 0) < 0.5 ? low : high) = middle;
    }
    return low;
  };
  const double expected = 0.5 * Banded::kLength * (elongation(20) + elongation(0));
  EXPECT_NEAR(longer, expected, 0.02 * expected);
}

}  // namespace
}  // namespace loosefit::drape
