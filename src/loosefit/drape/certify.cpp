#include "loosefit/drape/certify.h"

#include <limits>

#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/geometry/folded_edges.h"
#include "loosefit/solver/stability.h"

namespace loosefit::drape {

Certificate certify(ClothModel& model, const std::vector<Vec3>& x, const body::PosedBody& body,
                    const Stop& stop, double allowed_residual) {
  Certificate c;
  model.system().begin_step(x, std::numeric_limits<double>::infinity());
  const solver::Residual r = solver::residual_of(model.system(), model.system().gradient(x));
  c.residual = r.norm;
  c.residual_max = r.largest;
  const ClothMesh& cloth = model.mesh();
  const auto cuts = geometry::self_intersections(x, cloth.triangles);
  c.folded_edges = static_cast<int>(geometry::folded_edges(x, cloth.triangles).size());
  c.intersections_self = static_cast<int>(cuts.size()) + c.folded_edges;
  for (const auto& [a, b] : cuts)
    c.intersections_layers += cloth.triangle_layer[a] != cloth.triangle_layer[b];
  c.intersections_body =
      static_cast<int>(geometry::mesh_intersections(x, cloth.triangles, body.tree()).size() +
                       model.below_floor(x).size());
  c.allowed_residual = allowed_residual;
  if (c.settled()) c.stable = solver::is_stable(model.system(), x);
  c.reason = stop.reason;
  c.stop_reason = stop.text();
  // Balanced forces alone are no rest: say what is left.
  if (c.intersections_body + c.intersections_self > 0)
    c.stop_reason += ", but " + std::to_string(c.intersections_body) +
                     " triangle pairs cut the body and " + std::to_string(c.intersections_self) +
                     " the cloth itself";
  return c;
}

}  // namespace loosefit::drape
