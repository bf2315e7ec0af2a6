#pragma once
#include <deque>
#include <string>
#include <vector>

#include "loosefit/placement/sensor_probe.h"

namespace loosefit::placement {

/// One wearer of those over whom sites are ranked.
struct RankingWearer {
  std::string name;  ///< "run3"; stands beside the samples
  RankingGround ground;
  /// Where the given sites are on this wearer, each with the name of one on the first. Empty: the
  /// sensors stay where they are sewn, at the same places of the same pieces.
  std::vector<Site> sites = {};
};

/// Gives sites the scorecard's sensor: its footprint, its axis along or around the segment (a
/// stated angle other than 0 is kept). A site that was asked for by name and states a footprint of
/// its own keeps it with its angle; girth lines stay. What depends on the footprint is to be made
/// anew.
void give_sensor(const RankingGround& ground, const Scorecard& scorecard, std::vector<Site>& sites);

/// The same sites described anew. Girth lines are left out, named in `left_out`, when the
/// scorecard's sensor is no line.
std::vector<Site> sites_with_sensor(const RankingGround& ground, const std::vector<Site>& sites,
                                    const Scorecard& scorecard, std::vector<std::string>& left_out);

/// Measures sensors over all wearers, one sample per wearer and donning. Keeps references to its
/// arguments and to what the grounds refer to. Safe to use from several threads.
class Wearers {
 public:
  /// \throws InvalidInput without wearers.
  Wearers(const std::vector<RankingWearer>& wearers, const Scorecard& scorecard);

  const SensorProbe& first() const { return probes_.front(); }
  std::size_t count() const { return probes_.size(); }
  /// Whether some wearer has sites of its own: the garments are then cut differently.
  bool cut_differently() const;
  /// Per sample: the wearer's name, with the donning's number where there are several.
  std::vector<std::string> sample_names() const;
  /// Per sample the wearer's index.
  std::vector<int> sample_wearers() const;

  /// Of sites of the first wearer, in their order. \throws InvalidInput when another wearer has no
  /// such site, or the garment no cloth at its place.
  std::vector<WearerSamples> at(const std::vector<Site>& sites) const;
  /// Per site of the first wearer why it covers no skin, of whoever comes first; empty where it
  /// does on all. \throws as above.
  std::vector<std::string> not_covering(const std::vector<Site>& sites) const;
  /// Whether a place of the pattern covers skin on all.
  bool cover(const PatternPlace& place) const;
  /// Of a sensor at a place of the pattern; `turn` is the angle of its axis. A wearer whose garment
  /// has no cloth there has samples without metrics: the place is then not rated.
  WearerSamples at(const PatternPlace& place, const FootprintShape& shape, double turn) const;

 private:
  std::vector<Site> on(std::size_t wearer, const std::vector<Site>& sites) const;

  const std::vector<RankingWearer>& wearers_;
  std::deque<SensorProbe> probes_;
  std::vector<std::size_t> donnings_;     ///< per wearer
  std::vector<std::vector<Site>> sites_;  ///< per wearer: its own, with the scorecard's sensor
};

}  // namespace loosefit::placement
