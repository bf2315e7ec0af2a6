#include "loosefit/drape/phases/free_penetrations.h"

#include <algorithm>

#include "loosefit/drape/raise_offsets.h"
#include "loosefit/drape/refine_contact.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {

bool find_penetrations(ClothState& state) {
  state.penetrating = penetrating_triangles(state.model->mesh(), state.body->body, state.x);
  const bool low = !state.clear || state.last.residual < state.clear->residual;
  if (low && state.penetrating.empty()) state.keep(state.clear, state.last.residual);
  return !state.penetrating.empty();
}

void refine(ClothState& state, const std::set<int>& cut) {
  PenetrationTuning tuning = state.tuning.penetrations;
  const auto env = [](const char* n, double v) { return getenv(n) ? atof(getenv(n)) : v; };
  tuning.worth_a_point = env("LF_WORTH", tuning.worth_a_point);
  tuning.far = env("LF_FAR", tuning.far);
  if (cut.empty() && state.last.residual > env("LF_LATE", 1e9)) tuning.bulge = -1;
  const ContactRefinement done =
      refine_contact(*state.model, *state.body, state.x, cut, tuning);
  if (getenv("LF_DEBUG"))
    fprintf(stderr, "refine at %g: %d triangles %d places change %g mm, cuts %zu\n",
            state.last.residual, done.triangles, done.places, 1e3 * done.largest_change,
            state.penetrating.size());
}

void free_cuts(ClothState& state) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const auto report = [&](const char* when) {
    if (!getenv("LF_DEBUG")) return;
    const auto& tree = state.body->body.tree();
    const auto pairs = geometry::mesh_intersections(state.x, state.triangles(), tree);
    for (int t : state.penetrating) {
      const auto& lattice = state.model->lattice();
      const auto& pts = state.model->body().points();
      const Triangle& tr = state.triangles()[t];
      const Vec3 c = (state.x[tr[0]] + state.x[tr[1]] + state.x[tr[2]]) / 3;
      fprintf(stderr, "%s: cut %d at %.3f %.3f %.3f\n", when, t, c[0], c[1], c[2]);
      for (int i : lattice.points_of(t)) {
        const Vec3 p = pts[i].position(state.x);
        const double d = tree.signed_distance(p);
        if (d > 0.06e-3) continue;
        const double f = state.model->body().field_distance(pts[i], state.x, 0.05);
        fprintf(stderr, "   point %d w %.3f %.3f %.3f area %.2g exact %.4f field %.4f error %.4f seen %.4f\n", i, pts[i].weight[0], pts[i].weight[1], pts[i].weight[2], pts[i].area, 1e3*d, 1e3*f, 1e3*pts[i].field_error, 1e3*(f-pts[i].field_error));
      }
      const Vec3 n = (state.x[tr[1]]-state.x[tr[0]]).cross(state.x[tr[2]]-state.x[tr[0]]).normalized();
      for (const auto& [a, b] : pairs) if (a == t) {
        const auto& m = tree.mesh();
        fprintf(stderr, "   skin %d:", b);
        for (int v : m.triangles[b]) {
          const Vec3 q = m.vertices[v] - state.x[tr[0]];
          const Vec3 e1 = state.x[tr[1]]-state.x[tr[0]], e2 = state.x[tr[2]]-state.x[tr[0]];
          const Vec3 r = q - q.dot(n)*n;
          const double d11=e1.dot(e1), d12=e1.dot(e2), d22=e2.dot(e2), r1=r.dot(e1), r2=r.dot(e2), det=d11*d22-d12*d12;
          const double b1=(d22*r1-d12*r2)/det, b2=(d11*r2-d12*r1)/det;
          fprintf(stderr, " v%d height %.3f bary %.2f %.2f %.2f;", v, 1e3*q.dot(n), 1-b1-b2, b1, b2);
        }
        fprintf(stderr, "\n");
      }
    }
  };
  report("before");
  refine(state, state.penetrating);
  report("after");
  if (state.attempts[RecoveryKind::free_cuts] <= tuning.exact_rounds) return;
  raise_offsets_at_penetrations(*state.model, state.body->field->smooth_reach(), state.penetrating,
                                state.times_cut, tuning);
  state.report.held_off_triangles = static_cast<int>(state.times_cut.size());
}

void free_penetrations(ClothState& state) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const double wanted = state.options.residual_tolerance;
  state.times_cut.clear();
  state.lowest.reset(), state.clear.reset(), state.saddle.reset();
  state.attempts[RecoveryKind::free_cuts] = 0;
  state.report.held_off_triangles = 0;
  state.soften_contact(false);  // nothing is held off yet
  refine(state, {});
  // Penetrations are looked for long before the last digits of the balance are sought.
  for (std::size_t i = 0; i < tuning.look_tolerances.size(); ++i) {
    state.settle({std::max(tuning.look_tolerances[i], wanted), tuning.look_iterations,
                  tuning.look_first_dt[i]});
    if (state.is_over()) return;
    find_penetrations(state);
    refine(state, {});
  }
  settle_without_penetrations(state, tuning.first_dt);
}

void settle_without_penetrations(ClothState& state, double first_dt) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const double wanted = state.options.residual_tolerance;
  const auto freed = [&] { return state.recover(RecoveryPoint::at_rest); };
  // A round for the last digits, while there are still penetrations, would be thrown away.
  for (;; first_dt = tuning.near_rest_dt) {
    state.settle({std::max(tuning.tolerance, wanted), kNoLimit, first_dt});
    if (state.is_over()) return;
    if (freed()) continue;
    refine(state, {});
    if (wanted < state.last.residual) state.settle({wanted, kNoLimit, tuning.near_rest_dt});
    if (state.is_over() || !freed()) return;
  }
}

}  // namespace loosefit::drape
