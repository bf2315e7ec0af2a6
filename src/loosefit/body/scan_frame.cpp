#include "loosefit/body/scan_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/section.h"

namespace loosefit::body {
namespace {

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array<Unit, 4> kUnits = {{{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}}};

/// Who is taken for a standing person unasked: from toddlers, whom no other unit makes an adult, to
/// the tallest [m].
constexpr double kLikelyShortest = 0.75, kLikelyTallest = 2.3;

struct Box {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;
};

Box box_of(const std::vector<Vec3>& points) {
  Box box;
  for (const auto& p : points) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

std::string heights(double stature) {
  std::string text;
  for (const auto& unit : kUnits)
    text += fmt::format("{}{:.3g} m if these are {}", text.empty() ? "" : ", ",
                        stature * unit.metres, unit.name);
  return text;
}

/// Metres in a unit of the file, by its stature in that unit.
double metres_per_unit(double stature, const ScanOptions& options,
                       std::vector<std::string>& warnings) {
  const InputPlace place{options.file, 0, "units"};
  if (!options.units.empty()) {
    const std::optional<double> unit = metres_of(options.units);
    if (!unit)
      throw InvalidInput(place, "units \"" + printable(options.units) + "\"", "m, cm, mm or in");
    const double metres = stature * *unit;
    if (metres >= kLikelyShortest && metres <= kLikelyTallest) return *unit;
    if (metres >= kShortestPerson && metres <= kTallestPerson) {
      warnings.push_back(fmt::format("a height of {:.3g} m is that of few people: it would be {}",
                                     metres, heights(stature)));
      return *unit;
    }
    throw InvalidInput(
        place, fmt::format("a height of {:.3g} m with units = \"{}\"", metres, options.units),
        fmt::format("a standing person of {:g} to {:g} m", kShortestPerson, kTallestPerson),
        "the height would be " + heights(stature));
  }
  std::vector<Unit> likely;
  for (const auto& unit : kUnits) {
    const double metres = stature * unit.metres;
    if (metres >= kLikelyShortest && metres <= kLikelyTallest) likely.push_back(unit);
  }
  if (likely.size() != 1) {
    throw InvalidInput(
        place,
        fmt::format("a height of {:.4g} in the file, which is {}", stature, heights(stature)),
        likely.empty()
            ? fmt::format("a standing person of {:g} to {:g} m", kLikelyShortest, kLikelyTallest)
            : "one unit that makes it a standing person",
        "say which it is, for example units = \"cm\" (loosefit body: --units cm)");
  }
  warnings.push_back(
      fmt::format("no units given: the scan's {:.4g} from end to end are taken as {}", stature,
                  likely[0].name));
  return likely[0].metres;
}

void turn(geometry::TriangleMesh& mesh, Mat3& turned, const Mat3& by) {
  for (auto& p : mesh.vertices) p = by * p;
  turned = by * turned;
}

Mat3 about_z(double cosine, double sine) {
  Mat3 r;
  r << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
  return r;
}

/// File axes to z up.
void stand_up(geometry::TriangleMesh& mesh, const ScanOptions& options,
              std::vector<std::string>& warnings) {
  const Box box = box_of(mesh.vertices);
  const Vec3 extent = box.upper - box.lower;
  std::string up = options.up;
  if (up.empty()) {
    up = extent.y() > extent.z() ? "y" : "z";
    warnings.push_back("no up axis given: " + up + " is taken as up, the longer of y and z");
  }
  if (up != "y" && up != "z")
    throw InvalidInput({options.file, 0, "up"}, "\"" + printable(up) + "\"", "y or z");
  if (up == "y") {
    for (auto& p : mesh.vertices) p = Vec3(p.x(), -p.z(), p.y());
  }
}

/// Horizontal spread of a surface: the principal axes of its triangles.
struct Spread {
  double angle = 0;  ///< from x to the direction in which it spreads most [rad], −π/2 to π/2
  bool is_outstanding = false;  ///< it spreads clearly more that way than across
};

/// Of the triangles whose middles `counts` takes.
Spread spread_of(const geometry::TriangleMesh& mesh,
                 const std::function<bool(const Vec3&)>& counts) {
  constexpr double kOutstanding = 1.3;  // ratio of the variances along and across
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[std::size_t(t[0])], &b = mesh.vertices[std::size_t(t[1])],
               &c = mesh.vertices[std::size_t(t[2])];
    if (!counts((a + b + c) / 3)) continue;
    const double share = geometry::triangle_area(a, b, c);
    const Eigen::Vector2d middle = ((a + b + c) / 3).head<2>();
    mean += share * middle, moment += share * middle * middle.transpose(), area += share;
  }
  if (!(area > 0)) return {};
  mean /= area;
  const Eigen::Matrix2d variance = moment / area - mean * mean.transpose();
  const double sum = variance.trace(), difference = variance(0, 0) - variance(1, 1);
  const double apart = std::hypot(difference, 2 * variance(0, 1));
  if (!(sum + apart > kOutstanding * (sum - apart))) return {difference < 0 ? kPi / 2 : 0, false};
  return {0.5 * std::atan2(2 * variance(0, 1), difference), true};
}

Spread spread_of_all(const geometry::TriangleMesh& mesh) {
  return spread_of(mesh, [](const Vec3&) { return true; });
}

/// The coordinate below which half of the skin lies.
double median(const geometry::TriangleMesh& mesh, int axis) {
  std::vector<std::pair<double, double>> skin;  // of triangles: middle, area
  double half = 0, sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[std::size_t(t[0])], &b = mesh.vertices[std::size_t(t[1])],
               &c = mesh.vertices[std::size_t(t[2])];
    skin.emplace_back(((a + b + c) / 3)[axis], geometry::triangle_area(a, b, c));
    half += skin.back().second / 2;
  }
  std::ranges::sort(skin);
  for (const auto& [middle, area] : skin)
    if ((sum += area) >= half) return middle;
  return 0;
}

/// Of what is near the middle, legs and trunk, which lie alike if an arm is missing or held another
/// way.
Spread spread_of_core(const geometry::TriangleMesh& mesh) {
  constexpr double kRound = 0.13;  // of the stature
  const Box box = box_of(mesh.vertices);
  const double radius = kRound * (box.upper.z() - box.lower.z());
  const Eigen::Vector2d middle(median(mesh, 0), median(mesh, 1));
  return spread_of(mesh, [&](const Vec3& p) { return (p.head<2>() - middle).norm() < radius; });
}

/// Shoulders and arms are wider than the chest is deep: what spreads most comes to lie along x.
void turn_across(geometry::TriangleMesh& mesh, Mat3& turned, std::vector<std::string>& warnings) {
  constexpr double kStraight = 5;  // that a person may stand askew [degrees]
  const double angle = degrees(spread_of_all(mesh).angle);
  if (std::abs(angle) < kStraight) return;
  const Spread core = spread_of_core(mesh);
  if (core.is_outstanding && std::abs(degrees(core.angle)) < kStraight) return;
  if (std::abs(angle) > 90 - kStraight) {
    turn(mesh, turned, about_z(0, 1));
    warnings.push_back("the surface is wider along depth than along x: turned by 90 degrees");
    return;
  }
  turn(mesh, turned, about_z(std::cos(radians(angle)), -std::sin(radians(angle))));
  warnings.push_back(
      fmt::format("the person stands askew: turned by {:.0f} degrees about the vertical", -angle));
}

// Toes stick out in front of the ankles.
void face_forward(geometry::TriangleMesh& mesh, Mat3& turned, std::vector<std::string>& warnings) {
  const Box box = box_of(mesh.vertices);
  const double height = box.upper.z() - box.lower.z();
  double ankle = 0;
  int ankles = 0;
  double foot_low = std::numeric_limits<double>::infinity(), foot_high = -foot_low;
  for (const auto& p : mesh.vertices) {
    const double level = (p.z() - box.lower.z()) / height;
    if (level < 0.025) foot_low = std::min(foot_low, p.y()), foot_high = std::max(foot_high, p.y());
    if (level > 0.05 && level < 0.09) ankle += p.y(), ++ankles;
  }
  if (ankles == 0) return;
  const double middle = ankle / ankles;
  if (foot_high - middle <= 1.15 * (middle - foot_low)) return;
  turn(mesh, turned, about_z(-1, 0));
  warnings.push_back("the toes point to +y: turned by 180 degrees to face -y");
}

// Sideways by the head, which has no arms beside it; in depth by the trunk's waist.
Vec3 shift_to_origin(const geometry::TriangleMesh& mesh) {
  const Box box = box_of(mesh.vertices);
  const double height = box.upper.z() - box.lower.z();
  double x = 0, area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[std::size_t(t[0])], &b = mesh.vertices[std::size_t(t[1])],
               &c = mesh.vertices[std::size_t(t[2])];
    const Vec3 middle = (a + b + c) / 3;
    const double level = (middle.z() - box.lower.z()) / height;
    if (level < 0.85 || level > 0.98) continue;
    const double share = geometry::triangle_area(a, b, c);
    x += share * middle.x(), area += share;
  }
  if (area > 0) x /= area;
  const double waist = box.lower.z() + 0.62 * height;
  Box trunk;
  const auto loops = plane_section(mesh, Vec3(0, 0, waist), Vec3::UnitZ());
  if (const SectionLoop* loop = trunk_loop(loops, x)) trunk = box_of(loop->points);
  const double y =
      trunk.lower.y() < trunk.upper.y() ? 0.5 * (trunk.lower.y() + trunk.upper.y()) : 0;
  return -Vec3(x, y, box.lower.z());
}

}  // namespace

std::optional<double> metres_of(const std::string& unit) {
  for (const Unit& known : kUnits)
    if (unit == known.name) return known.metres;
  return {};
}

RigidMotion stand_in_our_frame(geometry::TriangleMesh& mesh, const ScanOptions& options,
                               std::vector<std::string>& warnings) {
  stand_up(mesh, options, warnings);
  const Box box = box_of(mesh.vertices);
  const double scale = metres_per_unit(box.upper.z() - box.lower.z(), options, warnings);
  for (auto& p : mesh.vertices) p *= scale;
  Mat3 turned = Mat3::Identity();
  turn_across(mesh, turned, warnings);
  face_forward(mesh, turned, warnings);
  const Vec3 shift = shift_to_origin(mesh);
  for (auto& p : mesh.vertices) p += shift;
  RigidMotion motion = RigidMotion::Identity();
  motion.linear() = turned;
  motion.translation() = shift;
  return motion;
}

}  // namespace loosefit::body
