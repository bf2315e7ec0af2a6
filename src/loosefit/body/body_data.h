#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::body {

/// One morph target: displacements of the rows it touches, in units of 0.1 mm (times its weight).
struct BodyField {
  std::vector<std::uint16_t> rows;                 ///< ascending
  std::vector<std::array<std::int16_t, 3>> shift;  ///< per entry of rows

  bool operator==(const BodyField&) const = default;
};

/// One bone of the rig; joints are indices into BodyData::joints.
struct Bone {
  std::string name;  ///< "upperarm01.L", …; parents come before children
  int parent = -1;
  int head = 0;
  int tail = 0;
};

/// The baked parametric body: everything needed to make a person, in our frame and in metres.
/// A row is a body vertex (first `body_vertices` rows) or a point behind them that only joints use.
struct BodyData {
  std::string source_sha256;  ///< of the targets file it was baked from
  int body_vertices = 0;
  std::vector<Vec3> base;  ///< per row [m]; not itself a person: always add macro fields
  std::vector<std::array<int, 4>> quads;  ///< body skin, closed, outward
  std::vector<int> mirror;                ///< row → row at (-x, y, z)
  std::vector<std::vector<int>> joints;   ///< joint position = mean of these rows
  std::vector<Bone> bones;
  std::vector<std::vector<std::pair<int, double>>>
      skin;                       ///< per body vertex: (bone, weight), sum 1
  std::vector<BodyField> fields;  ///< distinct and not zero
  std::map<std::string, int>
      field_of_name;  ///< "measure/measure-bust-increase" → field; -1: all zero

  /// Index of the bone. \throws InvalidInput when there is none of that name.
  int bone(const std::string& name) const;
};

/// Reads a baked file. \throws IoError when missing (says how to make it), damaged or of another
/// version.
BodyData read_body_data(const std::string& path);

/// Writes a baked file (zlib-compressed, little-endian). \throws IoError.
void write_body_data(const std::string& path, const BodyData& data);

}  // namespace loosefit::body
