#include "problem.h"

#include <limits>
#include <stdexcept>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/io/scenario.h"
#include "loosefit/kinds/shirt/lay_shirt.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/case_pattern.h"
#include "loosefit/solver/integrator.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/validate/drape_specimen.h"

namespace loosefit::bakeoff {
namespace {

/// The reference shirt (examples/reference-shirt.toml) on its body.
struct Shirt {
  pipeline::CaseBody body;
  garment::GarmentHierarchy garment;
  fabric::Material material;
  std::shared_ptr<const drape::ContactBody> skin;
  drape::DrapeOptions options;

  std::unique_ptr<drape::ClothModel> model(int level, double stiffness_share = 1,
                                           bool with_friction = true) const {
    fabric::Material m = material;
    if (!with_friction) m.friction_body = m.friction_self = 0;
    fabric::scale_membrane(m, stiffness_share);
    const bool finest = level + 1 == static_cast<int>(garment.levels.size());
    auto made = std::make_unique<drape::ClothModel>(garment.levels[level], m, options,
                                                    material.thickness * (finest ? 1.0 : 2.0));
    made->body().set_field(skin->field);
    return made;
  }
};

void settle(drape::ClothModel& model, particles::VectorField& x, double tolerance, int iterations,
            double first_dt) {
  solver::SettleOptions options;
  options.tolerance = tolerance;
  options.tangent = particles::BendingTangent::hinge;
  options.max_iterations = iterations;
  options.first_dt = first_dt;
  solver::make_quasi_static(model.system())->settle(x, options);
}

/// To the next finer level, bulged towards the smooth surface (PN triangles, Vlachos et al. 2001).
particles::VectorField refined(const Shirt& shirt, int level, const particles::VectorField& x) {
  const auto& parents = shirt.garment.parents[level + 1];
  const auto normal = geometry::vertex_normals(x, shirt.garment.levels[level].triangles);
  particles::VectorField fine(parents.size()), bulge(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const auto [a, b] = parents[i];
    const Vec3 edge = x[b] - x[a];
    fine[i] = 0.5 * (x[a] + x[b]);
    bulge[i] = (normal[b] * normal[b].dot(edge) - normal[a] * normal[a].dot(edge)) / 8;
  }
  const auto model = shirt.model(level + 1);
  model->system().begin_step(fine, std::numeric_limits<double>::infinity());
  const double allowed = model->self().max_step(fine, bulge);
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] += allowed * bulge[i];
  return fine;
}

Problem shirt_problem(const std::string& name, double edge_length, const std::string& what) {
  scenario::Scenario scenario = io::parse_scenario(R"([body]
sex = "female"
age = 30
height = 1.68
measurements = { chest = 0.88, waist = 0.72, hip = 0.97 }
[garment]
fit = { chest = 0.10, hip = 0.08, sleeve = 0.15, wrist = 0.20 }
[material]
name = "paper-cotton"
)",
                                                   "bakeoff.toml");
  auto shirt = std::make_shared<Shirt>();
  shirt->body = pipeline::make_body(scenario.body);
  shirt->material = scenario.studied().material.material;
  shirt->garment = garment::build_hierarchy(
      pipeline::make_pattern(scenario.studied().spec, shirt->body.body).pattern, edge_length,
      shirt->material);
  // As the dress stage: contract soft and without friction, then with both, then level by level.
  particles::VectorField x =
      dress::lay_round(shirt->garment.levels[0], shirt->body.path(0.0), kinds::lay_shirt);
  shirt->skin = drape::with_field(shirt->body.path(0.0), drape::bounds(x), 0.005);
  for (double share : {0.01, 0.1}) settle(*shirt->model(0, share, false), x, 30, 60, 0.01);
  int level = 0;
  {
    const auto model = shirt->model(0);
    if (shirt->garment.levels.size() > 1) {
      settle(*model, x, 1.0, 2000, 0.01);
      settle(*model, x, 0.1, 2000, 0.02);
    }
  }
  for (; level + 1 < static_cast<int>(shirt->garment.levels.size()); ++level) {
    if (level > 0) settle(*shirt->model(level), x, 0.1, 2000, 0.02);
    x = refined(*shirt, level, x);
  }
  Problem problem{name, what, static_cast<int>(x.size()), 0.1, {}};
  problem.make = [shirt, x, level] {
    struct Owned {
      std::shared_ptr<Shirt> shirt;
      std::unique_ptr<drape::ClothModel> model;
    };
    auto owned = std::make_shared<Owned>(Owned{shirt, shirt->model(level)});
    return World{owned, &owned->model->system(), x};
  };
  return problem;
}

Problem cusick_problem(const std::string& name) {
  const validate::DrapeTester tester;
  fabric::Material m;
  m.areal_density = 0.12;
  m.stiffness_warp = m.stiffness_weft = 300;
  m.poisson = 0;
  m.stiffness_shear = 150;
  m.bending_warp = m.bending_weft = m.areal_density * kGravity * 3.375e-6;  // length 1.5 cm
  const auto make = [=] {
    const validate::Specimen specimen = validate::cut_drape_specimen(tester, 0.006, m);
    auto bench = std::make_shared<validate::Bench>(specimen, m, validate::folded_start(tester, 6));
    bench->hold(validate::on_disc(specimen, tester));
    return World{bench, &bench->system(), bench->x};
  };
  return {name, "disc of 30 cm on a plate of 18 cm (Cusick), six folds to start with, 6 mm edges",
          static_cast<int>(make().x.size()), 0.1, make};
}

}  // namespace

std::vector<std::string> problem_names() {
  return {"shirt-20mm", "shirt-14mm", "shirt-10mm", "shirt-5mm", "cusick-6mm"};
}

Problem make_problem(const std::string& name) {
  if (name == "shirt-20mm")
    return shirt_problem(
        name, 0.020,
        "reference shirt as contracted, one level: the dress stage is part of the race");
  if (name == "shirt-14mm")
    return shirt_problem(name, 0.014,
                         "reference shirt, 28 mm level at a residual of 0.1, prolonged once");
  if (name == "shirt-10mm")
    return shirt_problem(name, 0.010,
                         "reference shirt, 20 mm level at a residual of 0.1, prolonged once");
  if (name == "shirt-5mm")
    return shirt_problem(name, 0.005,
                         "reference shirt, 10 mm level at a residual of 0.1, prolonged once");
  if (name == "cusick-6mm") return cusick_problem(name);
  throw std::out_of_range(name);
}

}  // namespace loosefit::bakeoff
