#include "loosefit/placement/site_state.h"

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/geometry/nearest_rotation.h"
#include "loosefit/geometry/principal_axes.h"
#include "loosefit/maps/statistics.h"

namespace loosefit::placement {
namespace {
constexpr double kNan = SiteState::kUnknown;

/// Mean rotation of a weighted sum of frames. NaN where they do not agree: where the mean of some
/// direction is shorter than half, as of directions spread over 120° to both sides.
Mat3 mean_rotation(const Mat3& sum, double weight) {
  constexpr double kLeastAgreement = 0.5;
  if (!sum.allFinite() || !(weight > 0)) return Mat3::Constant(kNan);
  const Mat3 mean = sum / weight;
  const double least = geometry::principal_axes(mean.transpose() * mean).values[0];
  return least < kLeastAgreement * kLeastAgreement ? Mat3(Mat3::Constant(kNan))
                                                   : geometry::nearest_rotation(sum);
}
}  // namespace

/// One sample of a footprint with its partner on the body.
struct StateMeter::Sample {
  int triangle = 0;
  double weight = 0;
  bool own_panel = true;  ///< the patch's direction holds here
  Vec2 direction;         ///< in the sample's panel
  Vec3 position;
  Vec3 normal;  ///< of the cloth, unit
  body::BodyPartner partner;
  body::SurfaceFrame body;  ///< at the partner
};

StateMeter::StateMeter(const garment::Garment& garment, const fabric::Material& material,
                       const WornState& state)
    : garment_(garment), material_(material), state_(state) {
  maps::require_fit(garment, {state.positions, state.body, state.worn});
  strains_ = maps::cloth_strains(garment, state.positions, material);
  const maps::MapInput input{garment, state.positions, state.worn, &material_, state.pressure};
  for (const FootprintReading& reading : footprint_readings()) {
    const auto* field = std::get_if<maps::ReadField>(&reading.array->read);
    const bool known = !reading.map->needs_forces || (state.pressure && !state.pressure->empty());
    if (field && known) fields_[reading.array] = (*field)(input);
  }
}

std::vector<StateMeter::Sample> StateMeter::sampled(const SensorPatch& patch) const {
  if (!patch.sample_directions.empty() &&
      patch.sample_directions.size() != patch.footprint.samples.size())
    throw InvalidInput("a sensor's patch: found " + std::to_string(patch.sample_directions.size()) +
                       " directions, expected " + std::to_string(patch.footprint.samples.size()) +
                       ", one for each sample");
  // Cables have a direction per sample, boards one for all.
  const bool each = !patch.sample_directions.empty();
  std::vector<Sample> samples;
  samples.reserve(patch.footprint.samples.size());
  for (std::size_t i = 0; i < patch.footprint.samples.size(); ++i) {
    const Footprint::Sample& at = patch.footprint.samples[i];
    const Triangle& corner = garment_.triangles[at.triangle];
    const int panel = garment_.triangle_panel[at.triangle];
    // Place and weight on the garment; the direction holds in the sensor's own panel only.
    Sample sample;
    sample.triangle = at.triangle;
    sample.weight = at.area;
    sample.own_panel = each || panel == patch.panel;
    sample.direction = each ? patch.sample_directions[i] : patch.direction;
    // Position and normal of the draped cloth.
    sample.normal = Vec3::Zero();
    sample.position = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      sample.position += at.barycentric[k] * state_.positions[corner[k]];
      sample.normal += at.barycentric[k] * state_.worn.normals[corner[k]];
    }
    sample.normal.normalize();
    // The skin under it, with the frame that orientations are told in.
    sample.partner = state_.body.partners().find_on_surface(sample.position, sample.normal,
                                                            state_.worn.panel_part[panel]);
    const geometry::ClosestPoint& exact = sample.partner.exact;
    sample.body = body::surface_frame(sample.partner.normal,
                                      body::at_point(state_.body->surface, state_.body.axes(),
                                                     exact.triangle, exact.barycentric));
    samples.push_back(sample);
  }
  return samples;
}

Mat3 StateMeter::cloth_frame(const SensorPatch& patch, const std::vector<Sample>& samples) const {
  Vec3 along = Vec3::Zero();  // mean image of the direction, where it holds
  int last = -1;
  Mat3 frame = Mat3::Identity();
  const auto frame_at = [&](const Sample& sample) -> const Mat3& {
    if (sample.triangle != last || !patch.sample_directions.empty())
      frame = maps::triangle_frame(garment_, sample.triangle, state_.positions, sample.direction);
    last = sample.triangle;
    return frame;
  };
  for (const Sample& sample : samples)
    if (sample.own_panel && frame_at(sample).allFinite())
      along += sample.weight * frame_at(sample).col(1);
  Mat3 sum = Mat3::Zero();
  double weight = 0;
  for (const Sample& sample : samples) {
    const Mat3& own = frame_at(sample);
    if (!own.allFinite()) continue;
    // Beyond a seam the pattern runs another way: the sensor's axis goes straight on.
    sum += sample.weight * (sample.own_panel ? own : body::surface_frame(own.col(2), along).axes);
    weight += sample.weight;
  }
  return mean_rotation(sum, weight);
}

SkinUnderSensor StateMeter::skin_under(const SensorPatch& patch) const {
  const std::vector<Sample> samples = sampled(patch);
  double known = 0, all = 0;
  Vec3 axis = Vec3::Zero();
  for (const Sample& sample : samples) {
    all += sample.weight;
    if (!sample.body.has_direction) continue;
    known += sample.weight;
    axis += sample.weight * sample.body.axes.col(1);
  }
  SkinUnderSensor skin;
  skin.body = &state_.body.body();
  skin.has_direction = 2 * known >= all && known > 0;
  // One direction for the whole patch: where the segment gives none, that of the sensor serves, for
  // angles between two states do not depend on it.
  const Mat3 cloth = cloth_frame(patch, samples);
  const Vec3 otherwise = skin.has_direction  ? Vec3(axis.normalized())
                         : cloth.allFinite() ? Vec3(cloth.col(1))
                                             : Vec3(Vec3::Zero());
  const std::vector<Vec3> none(state_.body.axes().size(), Vec3::Zero());
  for (const Sample& sample : samples) {
    skin.points.push_back(body::skin_point(state_.body,
                                           skin.has_direction ? state_.body.axes() : none,
                                           sample.partner.exact, otherwise));
    skin.offsets.push_back(maps::offset_on_skin(skin.points.back(), state_.body, sample.position));
  }
  return skin;
}

std::vector<double> StateMeter::sample_values(const maps::MapArray& array, const SensorPatch& patch,
                                              const std::vector<Sample>& samples) const {
  std::vector<double> values(samples.size(), kNan);
  if (const auto* of_cloth = std::get_if<maps::ReadCloth>(&array.read)) {
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].own_panel || !array.along_sensor)
        values[i] = (*of_cloth)(strains_[samples[i].triangle], samples[i].direction);
  } else if (const auto* over_skin = std::get_if<maps::ReadOverSkin>(&array.read)) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Footprint::Sample& at = patch.footprint.samples[i];
      values[i] = (*over_skin)(
          {samples[i].partner,
           maps::smooth_distance(state_.worn.curved[at.triangle], at.barycentric,
                                 samples[i].partner.exact.distance),
           samples[i].normal, &material_,
           garment_.triangle_padding.empty() ? 0.0 : garment_.triangle_padding[at.triangle]});
    }
  } else if (const auto field = fields_.find(&array); field != fields_.end()) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Footprint::Sample& at = patch.footprint.samples[i];
      values[i] = 0;
      for (int k = 0; k < 3; ++k)
        values[i] += at.barycentric[k] * field->second[garment_.triangles[at.triangle][k]];
    }
  }
  return values;
}

void StateMeter::add_readings(const SensorPatch& patch, const std::vector<Sample>& samples,
                              SiteState& site) const {
  std::vector<double> weights;
  for (const Sample& sample : samples) weights.push_back(sample.weight);
  const maps::MapArray* summed_up = nullptr;  // readings of one array stand next to each other
  maps::MapStatistics summary;
  for (const FootprintReading& reading : footprint_readings()) {
    const maps::MapArray& array = *reading.array;
    if (reading.over == maps::OverFootprint::rigid) {
      const auto* of_slip = std::get_if<maps::ReadSlip>(&array.read);
      site.readings.push_back(of_slip ? (*of_slip)(site.slip) : reading.rigid(site.orientation));
      continue;
    }
    if (summed_up != &array)
      summary = maps::statistics(sample_values(array, patch, samples), weights);
    summed_up = &array;
    site.readings.push_back(reading.over == maps::OverFootprint::mean ? summary.area_mean
                                                                      : summary.p95);
  }
}

void StateMeter::add_orientation(const std::vector<Sample>& samples, SiteState& site) const {
  Mat3 frames = Mat3::Zero();
  Vec3 normals = Vec3::Zero();
  double all = 0, directed = 0;
  for (const Sample& sample : samples) {
    all += sample.weight;
    normals += sample.weight * sample.partner.normal;
    if (!sample.body.has_direction) continue;
    directed += sample.weight;
    frames += sample.weight * sample.body.axes;
  }
  if (!site.garment_frame.allFinite()) return;
  const Mat3 body = mean_rotation(frames, directed);
  if (2 * directed >= all && body.allFinite()) {
    site.orientation = maps::orientation_of(body.transpose() * site.garment_frame);
  } else if (normals.norm() > 0) {
    const Mat3 any = body::surface_frame(normals.normalized(), Vec3::Zero()).axes;
    site.orientation.angular_deviation =
        maps::orientation_of(any.transpose() * site.garment_frame).angular_deviation;
  }
}

void StateMeter::add_change(const SkinUnderSensor& reference, const std::vector<Sample>& samples,
                            SiteState& site) const {
  body::require_same_wearer(*reference.body, state_.body);
  if (reference.points.size() != samples.size())
    throw InvalidInput("a sensor's reference: found " + std::to_string(reference.points.size()) +
                       " places on the skin, expected " + std::to_string(samples.size()) +
                       ", one for each sample of the footprint");
  Mat3 frames = Mat3::Zero();
  Vec3 change = Vec3::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const body::SkinPoint& point = reference.points[i];
    frames += samples[i].weight * body::frame_of(point, state_.body).axes;
    change += samples[i].weight * (maps::offset_on_skin(point, state_.body, samples[i].position) -
                                   reference.offsets[i]);
    weight += samples[i].weight;
  }
  const Mat3 skin = mean_rotation(frames, weight);
  site.on_skin = skin.transpose() * site.garment_frame;
  if (weight > 0 && skin.allFinite())
    site.slip = maps::slip_of(change / weight, reference.has_direction);
}

SiteState StateMeter::measure(const SensorPatch& patch, const SkinUnderSensor* reference) const {
  const std::vector<Sample> samples = sampled(patch);
  SiteState site;
  site.posture = state_.posture;
  site.donning = state_.donning;
  site.garment_frame = cloth_frame(patch, samples);
  add_orientation(samples, site);
  if (reference) add_change(*reference, samples, site);
  add_readings(patch, samples, site);
  return site;
}

}  // namespace loosefit::placement
