#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "loosefit/body/body_data.h"

namespace loosefit::body {

/// The four source files as they are: decimetres, y up, z forward, helpers included.
struct RawBodyData {
  std::vector<std::array<std::int32_t, 3>> base;  ///< per vertex, units of 1e-4 dm
  std::vector<std::array<int, 4>> faces;          ///< body first, then helpers
  std::vector<int> mirror;                        ///< vertex → vertex at (-x, y, z)
  std::vector<std::string> target_names;          ///< sorted; block i of the targets file is name i
  std::string targets_path;
  std::string targets_sha256;
};

/// Displacements of all vertices by one target, units of 1e-3 dm.
using TargetBlock = std::vector<std::array<std::int16_t, 3>>;

/// Reads mesh and target list and checks sizes, names, face records, mirror symmetry.
/// \throws IoError, InvalidInput naming the file and what differs.
RawBodyData read_raw_body_data(const std::string& folder);

/// Reads block `index` of the targets file as it stands.
TargetBlock read_target_block(const RawBodyData& raw, int index);

/// Makes a target mirror symmetric where it should be: several targets of the package are lopsided.
/// Body groups only; the intentionally one-sided targets stay (their list is in the source).
void repair_target(const RawBodyData& raw, const std::string& name, TargetBlock& block);

/// Repairs, reduces to what garments need, turns into our frame: the body of read_body_data.
BodyData bake_body_data(const std::string& folder);

}  // namespace loosefit::body
