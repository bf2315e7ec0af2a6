#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/scan_sections.h"

namespace loosefit::body {

/// A level tape round the trunk.
struct TrunkTape {
  double level = 0;  ///< z [m]
  double girth = 0;  ///< [m]
};

struct TrunkTapes {
  TrunkTape chest, waist, hip;
};

/// Chest, waist and hip of a scan, each taped round what of a level section is labelled as no arm:
/// neither arms grown together with the trunk nor hands grown together with a thigh. Chest: the
/// fullest level between 0.07 and 0.02 of the stature below the armpit. Hip: the fullest between
/// 0.01 and 0.10 above the crotch. Waist: the level of the natural waist, as on the parametric body
/// and unlike the narrowest level, which on a belly lies above or below it.
/// A tape that lies off the skin, reaches much farther to one side, or jumps from one level to the
/// next goes round something else too; what can still be told is warned of.
/// \param labelled its surface, segment and side are read.
/// \throws GeometryError where a level has no trunk, or the tape lies far off the skin.
TrunkTapes tape_trunk(const ScanSections& sections, const Body& labelled,
                      std::vector<std::string>& warnings);

}  // namespace loosefit::body
