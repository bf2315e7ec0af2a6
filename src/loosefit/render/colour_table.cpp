#include "loosefit/render/colour_table.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace loosefit::render {
namespace {
using Lab = Eigen::Vector3d;

double to_linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double to_gamma(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

const Eigen::Matrix3d kLmsFromRgb =
    (Eigen::Matrix3d() << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451,
     0.1073969566, 0.0883024619, 0.2817188376, 0.6299787005)
        .finished();
const Eigen::Matrix3d kLabFromLms =
    (Eigen::Matrix3d() << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050,
     0.4505937099, 0.0259040371, 0.7827717662, -0.8086757660)
        .finished();

Lab lab_from_hex(unsigned hex) {
  const Eigen::Vector3d rgb(to_linear((hex >> 16 & 255) / 255.0),
                            to_linear((hex >> 8 & 255) / 255.0), to_linear((hex & 255) / 255.0));
  return kLabFromLms * (kLmsFromRgb * rgb).unaryExpr([](double c) { return std::cbrt(c); });
}

Rgb rgb_from_lab(const Lab& lab) {
  const Eigen::Vector3d root = kLabFromLms.inverse() * lab;
  const Eigen::Vector3d rgb = kLmsFromRgb.inverse() * root.array().cube().matrix();
  Rgb out;
  for (int k = 0; k < 3; ++k)
    out[k] = static_cast<std::uint8_t>(
        std::lround(255 * std::clamp(to_gamma(std::clamp(rgb[k], 0.0, 1.0)), 0.0, 1.0)));
  return out;
}

/// Catmull-Rom curve through the anchors, resampled at equal perceived distance.
ColourTable smooth_path(const std::vector<Lab>& anchors) {
  constexpr int kFine = 4096;
  const int spans = static_cast<int>(anchors.size()) - 1;
  const auto anchor = [&](int i) -> Lab {
    if (i < 0) return 2 * anchors.front() - anchors[1];
    if (i > spans) return 2 * anchors.back() - anchors[spans - 1];
    return anchors[i];
  };
  std::vector<Lab> curve;
  std::vector<double> length{0};
  for (int i = 0; i <= kFine; ++i) {
    const double s = static_cast<double>(i) * spans / kFine;
    const int k = std::min(static_cast<int>(s), spans - 1);
    const double t = s - k;
    const Lab a = anchor(k - 1), b = anchor(k), c = anchor(k + 1), d = anchor(k + 2);
    curve.push_back(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                           (3 * b - a - 3 * c + d) * t * t * t));
    if (i > 0) length.push_back(length.back() + (curve[i] - curve[i - 1]).norm());
  }
  ColourTable table;
  for (int i = 0, j = 0; i < 256; ++i) {
    const double wanted = length.back() * i / 255;
    while (j < kFine - 1 && length[j + 1] < wanted) ++j;
    const double share = (wanted - length[j]) / (length[j + 1] - length[j]);
    table[i] = rgb_from_lab(curve[j] + share * (curve[j + 1] - curve[j]));
  }
  return table;
}

ColourTable two_arms(Lab low, const Lab& middle, Lab high) {
  low[0] = high[0] = 0.5 * (low[0] + high[0]);
  ColourTable table;
  for (int i = 0; i < 256; ++i) {
    const double s = (i - 127.5) / 127.5;
    const Lab& end = s < 0 ? low : high;
    table[i] = rgb_from_lab(middle + std::abs(s) * (end - middle));
  }
  return table;
}
}  // namespace

const ColourTable& sequential_colours() {
  static const ColourTable table =
      smooth_path({lab_from_hex(0x440154), lab_from_hex(0x3b528b), lab_from_hex(0x21918c),
                   lab_from_hex(0x5ec962), lab_from_hex(0xfde725)});
  return table;
}

const ColourTable& diverging_colours() {
  static const ColourTable table =
      two_arms(lab_from_hex(0x2458a8), lab_from_hex(0xefeeec), lab_from_hex(0xb02a30));
  return table;
}

const ColourTable& colours_of(const maps::MapArrayStyle& map) {
  return map.diverging ? diverging_colours() : sequential_colours();
}

double colour_share(const maps::MapArrayStyle& map, double value) {
  if (std::isnan(value)) return value;
  const std::vector<double>& breaks = map.breaks;
  if (breaks.size() < 2)
    return std::clamp((value - map.range_low) / (map.range_high - map.range_low), 0.0, 1.0);
  if (value >= breaks.back()) return 1;
  for (std::size_t i = breaks.size() - 1; i-- > 0;)
    if (value >= breaks[i])
      return (static_cast<double>(i) + (value - breaks[i]) / (breaks[i + 1] - breaks[i])) /
             static_cast<double>(breaks.size() - 1);
  return 0;
}

}  // namespace loosefit::render
