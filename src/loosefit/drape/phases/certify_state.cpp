#include "loosefit/drape/phases/certify_state.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "loosefit/drape/certify.h"
#include "loosefit/drape/explain_unsettled.h"

namespace loosefit::drape {
namespace {

/// By the number of intersections, settled before not, stable before not, then by the residual.
bool better(const Certificate& a, const Certificate& b) {
  const auto rank = [](const Certificate& c) {
    const int cuts = c.intersections_body + c.intersections_self;
    return std::tuple(cuts, !c.settled(), !c.stable.value_or(false), c.residual);
  };
  return rank(a) < rank(b);
}

Certificate certified(ClothState& state, const Stop& stop) {
  return certify(*state.model, state.x, state.body->body, stop,
                 std::max(state.options.residual_tolerance, solver::kRestTolerance));
}

/// Goes back to a kept state and certifies it.
Certificate take(ClothState& state, const ClothState::Kept& kept) {
  go_back(state, kept);
  return certified(state, state.how_it_ended());
}

constexpr double kMostOfArea = 0.97;  ///< that SettleReport::bearing_distance speaks of [–]

struct AreaAt {
  double distance = 0, area = 0;  // [m], [m²]
};

/// Distance within which that share of the area lies.
std::optional<double> distance_within(std::vector<AreaAt> areas, double share) {
  std::sort(areas.begin(), areas.end(),
            [](const AreaAt& a, const AreaAt& b) { return a.distance < b.distance; });
  double left = 0;
  for (const AreaAt& a : areas) left += share * a.area;
  for (const AreaAt& a : areas)
    if ((left -= a.area) <= 0) return a.distance;
  return {};
}

/// Where the contact points lie that bear a force. The field is asked for a bound, the surfaces
/// behind it for the distance.
void add_bearing(const contact::BodyContact& contact, const contact::DistanceField& field,
                 const std::vector<Vec3>& x, double largest_field_error,
                 std::vector<AreaAt>& bearing) {
  for (int i : contact.bearing(x)) {
    const contact::ContactPoint& p = contact.points()[i];
    const double seen = contact.field_distance(p, x, p.offset + largest_field_error);
    bearing.push_back(
        {field.exact_distance(p.position(x), std::abs(seen) + largest_field_error), p.area});
  }
}

}  // namespace

void go_back(ClothState& state, const ClothState::Kept& kept) {
  state.x = kept.x;
  state.body = kept.body;
  state.start = kept.start;
  state.model->recall(kept.memory);
  state.model->set_friction_share(1);  // it may be loosened where time was up on the way
  state.report.held_off_triangles = kept.held_off_triangles;
  state.times_cut = kept.times_cut;
  state.went_back = kept.stop;
}

void measure_certificate(ClothState& state) {
  state.certificate = certified(state, state.how_it_ended());
}

void settle_nearer(ClothState& state) {
  const CertifyTuning& tuning = state.tuning.certify;
  const int earlier = state.attempts[RecoveryKind::nearer_to_rest] - 1;
  const double share = tuning.first_share * std::pow(tuning.next_share, earlier);
  state.settle(
      {share * state.options.residual_tolerance, kNoLimit, state.tuning.penetrations.near_rest_dt});
  measure_certificate(state);
}

void take_best_state(ClothState& state) {
  state.best_was_taken = true;
  std::optional<ClothState::Kept> now;
  state.keep(now, state.certificate.residual);
  const ClothState::Kept* best = &*now;
  for (const auto* other : {&state.lowest, &state.clear, &state.first_try, &state.saddle}) {
    if (!other->has_value()) continue;
    const Certificate certificate = take(state, **other);
    if (!better(certificate, state.certificate)) continue;
    state.certificate = certificate;
    best = &**other;
  }
  state.certificate = take(state, *best);
}

void certify_state(ClothState& state) {
  state.best_was_taken = false;
  for (RecoveryKind kind :
       {RecoveryKind::nearer_to_rest, RecoveryKind::leave_saddle, RecoveryKind::best_state})
    state.attempts[kind] = 0;
  measure_certificate(state);
  while (state.recover(RecoveryPoint::certified)) {
  }
}

Drape make_drape(ClothState& state) {
  Drape drape;
  drape.certificate = state.certificate;
  if (!state.certificate.settled()) {
    drape.unsettled = explain_unsettled(*state.model, state.garments(), state.x, state.body->body,
                                        state.certificate);
    if (state.falling) drape.unsettled->why = state.falling->text();
  }
  // Contacts and what they bear.
  std::vector<AreaAt> bearing;
  SettleReport& report = state.report;
  report.contacts_self = state.model->self().active(state.x);
  report.floor_force = state.model->floor_force(state.x);
  report.contacts_body = 0;
  const contact::DistanceField& field = *state.body->field;
  report.coarsened_field = field.is_coarsened() ? field.spacing() : 0;
  report.largest_contact_offset = 0;
  drape.body_contact_force.assign(state.x.size(), Vec3::Zero());
  drape.body_normal_force.assign(state.x.size(), 0.0);
  for (int l = 0; l < state.layer_count(); ++l) {
    const contact::BodyContact& contact = state.model->body(l);
    report.contacts_body += contact.active(state.x);
    for (const contact::ContactPoint& p : contact.points())
      report.largest_contact_offset = std::max(report.largest_contact_offset, p.offset);
    add_bearing(contact, field, state.x, state.tuning.penetrations.largest_field_error, bearing);
    contact.add_gradient(state.x, drape.body_contact_force);
    contact.add_normal_force(state.x, drape.body_normal_force);
  }
  report.bearing_area = 0;
  for (const AreaAt& a : bearing) report.bearing_area += a.area;
  report.bearing_distance = distance_within(std::move(bearing), kMostOfArea);
  for (Vec3& f : drape.body_contact_force) f = -f;
  drape.positions = state.x;
  drape.report = report;
  return drape;
}

}  // namespace loosefit::drape
