#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::report {

/// Arrays for a page, one after the other in one block of bytes. Each `add` returns the JSON that
/// tells the page how to read its array back:
/// `{"at": byte offset, "count": numbers, "bytes": 1|2|4 per number, "size": numbers per item}`,
/// and of rounded numbers `"low"` and `"step"` per component: value = low + step · stored.
/// So that they shrink when compressed (neighbours in a mesh are alike), each stored number is its
/// difference to that of the item before, modulo 2^(8 · bytes), and of all numbers of an array
/// first the lowest bytes are written, then the next ones.
class PackedArrays {
 public:
  /// Whole numbers from 0, in as few bytes as the greatest needs. \throws Error for negative ones.
  std::string add_counts(const std::vector<int>& values, int size = 1);
  /// Numbers rounded to 65535 even steps between the least and the greatest; 65535 itself is NaN
  /// (also of infinities). The error is at most half a step.
  std::string add_values(const std::vector<double>& values);
  /// Points, rounded alike per coordinate; they are finite.
  std::string add_points(const std::vector<Vec3>& points);
  std::string add_points(const std::vector<Vec2>& points);

  /// The block, compressed with gzip, as base64.
  std::string gzip_base64() const;
  std::size_t bytes() const { return block_.size(); }

 private:
  std::size_t append(const std::vector<std::uint32_t>& stored, int bytes, std::size_t size);
  std::string add_rounded(const std::vector<std::vector<double>>& components);
  std::string block_;
};

/// The stored number that stands for "not defined".
inline constexpr std::uint32_t kNotDefined = 65535;

/// Bytes in the gzip format, at the best level; the same bytes for the same input.
/// \throws Error when memory runs out.
std::string gzipped(const std::string& bytes);

}  // namespace loosefit::report
