#include "loosefit/report/packed_arrays.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"
#include "loosefit/report/html.h"

namespace loosefit::report {
namespace {

constexpr double kSteps = 65534;  // the stored numbers are 0 … 65534

std::string joined(const std::vector<double>& values) {
  std::string text;
  for (double value : values) text += fmt::format("{}{}", text.empty() ? "" : ",", value);
  return "[" + text + "]";
}

template <class Point>
std::vector<std::vector<double>> components_of(const std::vector<Point>& points) {
  std::vector<std::vector<double>> components(Point::RowsAtCompileTime);
  for (const Point& p : points)
    for (int k = 0; k < p.size(); ++k) components[k].push_back(p[k]);
  return components;
}

}  // namespace

std::size_t PackedArrays::append(const std::vector<std::uint32_t>& stored, int bytes,
                                 std::size_t size) {
  const std::size_t at = block_.size(), count = stored.size();
  block_.resize(at + count * bytes);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t change = stored[i] - (i < size ? 0 : stored[i - size]);
    for (int plane = 0; plane < bytes; ++plane)
      block_[at + plane * count + i] = static_cast<char>(change >> 8 * plane & 255);
  }
  return at;
}

std::string PackedArrays::add_counts(const std::vector<int>& values, int size) {
  int greatest = 0;
  for (int value : values) {
    LOOSEFIT_ASSERT(value >= 0);
    greatest = std::max(greatest, value);
  }
  const int bytes = greatest <= 255 ? 1 : greatest <= 65535 ? 2 : 4;
  const std::size_t at = append({values.begin(), values.end()}, bytes, size);
  return fmt::format(R"({{"at":{},"count":{},"bytes":{},"size":{}}})", at, values.size(), bytes,
                     size);
}

std::string PackedArrays::add_rounded(const std::vector<std::vector<double>>& components) {
  const std::size_t items = components.empty() ? 0 : components.front().size();
  std::vector<double> lows, steps;
  std::vector<std::uint32_t> stored(items * components.size());
  for (std::size_t k = 0; k < components.size(); ++k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (double value : components[k])
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    if (!(low <= high)) low = high = 0;
    const double step = high > low ? (high - low) / kSteps : 1;
    for (std::size_t i = 0; i < items; ++i) {
      const double value = components[k][i];
      stored[i * components.size() + k] =
          std::isfinite(value) ? static_cast<std::uint32_t>(std::lround((value - low) / step))
                               : kNotDefined;
    }
    lows.push_back(low);
    steps.push_back(step);
  }
  const std::size_t at = append(stored, 2, components.size());
  return fmt::format(R"({{"at":{},"count":{},"bytes":2,"size":{},"low":{},"step":{}}})", at,
                     stored.size(), components.size(), joined(lows), joined(steps));
}

std::string PackedArrays::add_values(const std::vector<double>& values) {
  return add_rounded({values});
}
std::string PackedArrays::add_points(const std::vector<Vec3>& points) {
  return add_rounded(components_of(points));
}
std::string PackedArrays::add_points(const std::vector<Vec2>& points) {
  return add_rounded(components_of(points));
}

std::string PackedArrays::gzip_base64() const { return base64(gzipped(block_)); }

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  constexpr int kGzipHeader = 16;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + kGzipHeader, 9,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw Error("cannot compress the arrays of the report: out of memory");
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int outcome = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (outcome != Z_STREAM_END) throw Error("cannot compress the arrays of the report");
  return out;
}

}  // namespace loosefit::report
