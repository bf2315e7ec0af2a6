#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/placement/site_state.h"

namespace loosefit::placement {

/// The numbers by which a site is judged, from what it meets in its states; units in the names.
/// What the states do not tell is left out, never made up. Each donning is summed up by itself, in
/// ascending order of donning: one sample of what a wearer meets. "Reference": the state of posture
/// `reference_posture` of that donning; "swing": range over its postures (greatest minus least;
/// from 20 postures on 95th minus 5th percentile).
///
/// | name                                   | over the states                                     |
/// |----------------------------------------|-----------------------------------------------------|
/// | angular_deviation_deg, rotation_deg,   | in the reference posture                            |
/// | tilt_sagittal_deg, tilt_lateral_deg,   | (angles with a sign keep it)                        |
/// | twist_deg                              |                                                     |
/// | tilt_across_deg, tilt_along_deg        | the same tilt about the sensor's own axes           |
/// | coe_across_deg, coe_along_deg,         | in the state of the greatest calibrated error, its  |
/// | coe_normal_deg                         | turn about the sensor's axes, with its sign         |
/// | coe_rms_deg, coe_p95_deg               | calibrated orientation error over all states but    |
/// |                                        | the reference, each against it                      |
/// | donning_coe_deg                        | RMS over the other donnings of the angle between    |
/// |                                        | the sensor's orientations, reference posture        |
/// | gap_mm                                 | mean over states of the footprint's mean            |
/// | gap_worst_mm                           | greatest over states of the footprint's worst 5 %   |
/// | gap_swing_mm                           | swing of the footprint's mean                       |
/// | contact_ratio                          | least over states                                   |
/// | contact_duty                           | share of states with a contact ratio of at least 0.9|
/// | pressure_kPa                           | mean over states of the footprint's mean            |
/// | pressure_min_kPa, pressure_swing_kPa   | least over states, swing of the footprint's mean    |
/// | strain, crimp                          | in the reference posture                            |
/// | strain_swing                           | swing                                               |
/// | slack                                  | greatest over states                                |
/// | slip_mm                                | greatest over states, each against the reference    |
///
/// The error, the duty, minimum, swings and slip need at least two postures of one donning, the
/// donning error two donnings. For it the body must stand alike in the reference posture of all
/// donnings. (docs/theory/sensor_metrics.md 3 to 7.)
std::vector<std::map<std::string, double>> site_metrics_by_donning(
    const std::vector<SiteState>& states, int reference_posture = 0);

/// The numbers of one of these states by itself, under the same names: as if its posture were the
/// reference; in another posture also turn and slip since the reference posture of its donning.
/// What compares several postures (swings, duty) is left out.
std::map<std::string, double> site_metrics_of_state(const std::vector<SiteState>& states,
                                                    std::size_t index, int reference_posture = 0);

/// Measures sensors over all states of a study. Finds bodies once, so that many places can be
/// tried.
class SiteMeter {
 public:
  /// Keeps references to all arguments and to what the states refer to. A donning whose reference
  /// posture is missing (its drape did not settle) counts with what needs no reference.
  /// \throws InvalidInput for no states, two states of the same posture and donning, a state that
  /// does not fit the garment, or bodies that are not one wearer's.
  SiteMeter(const garment::Garment& garment, const fabric::Material& material,
            const std::vector<WornState>& states, int reference_posture = 0);

  /// One entry per state, in their order. Safe to call from several threads.
  std::vector<SiteState> measure(const SensorPatch& patch) const;
  int reference_posture() const { return reference_posture_; }

 private:
  std::vector<StateMeter> meters_;
  std::vector<int> reference_of_;  ///< per state: index of its reference, −1 without
  int reference_posture_;
};

}  // namespace loosefit::placement
