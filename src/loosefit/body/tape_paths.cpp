#include "loosefit/body/tape_paths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"

namespace loosefit::body {
namespace {

// Half the perimeter of an ellipse (Ramanujan 1914).
double half_ellipse(double a, double b) {
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  return 0.5 * kPi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
}

}  // namespace

double trunk_girth(const geometry::TriangleMesh& mesh, double z) {
  const auto loops = plane_section(mesh, Vec3(0, 0, z), Vec3::UnitZ());
  const SectionLoop* trunk = trunk_loop(loops);
  if (!trunk) throw GeometryError("body: found no closed section round the trunk at this level");
  return hull_perimeter(trunk->points, Vec3::UnitZ());
}

double trunk_girth_front(const geometry::TriangleMesh& mesh, double z) {
  const auto loops = plane_section(mesh, Vec3(0, 0, z), Vec3::UnitZ());
  const SectionLoop* trunk = trunk_loop(loops);
  if (!trunk) throw GeometryError("body: found no closed section round the trunk at this level");
  std::vector<Vec2> points;
  for (const Vec3& p : trunk->points) points.emplace_back(p.x(), p.y());
  const std::vector<Vec2> hull = convex_hull(points);
  const auto aside = [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); };
  const auto right = std::min_element(hull.begin(), hull.end(), aside),
             left = std::max_element(hull.begin(), hull.end(), aside);
  // Counter-clockwise seen from above, the front (−y) runs from the wearer's right to the left.
  double length = 0;
  const std::size_t n = hull.size();
  for (auto i = std::size_t(right - hull.begin()); i != std::size_t(left - hull.begin());
       i = (i + 1) % n)
    length += (hull[(i + 1) % n] - hull[i]).norm();
  return length;
}

double girth_round(const geometry::TriangleMesh& mesh, const Vec3& origin, const Vec3& normal) {
  for (const auto& loop : plane_section(mesh, origin, normal)) {
    if (loop_contains(loop, normal, origin)) return hull_perimeter(loop.points, normal);
  }
  throw GeometryError("body: found no closed section round this point");
}

namespace {

/// Tape down one side of the body, behind (+1) or in front (−1) of the line from start to end.
double taut_down(const geometry::TriangleMesh& mesh, const Vec3& from, double down_to,
                 double behind) {
  // Height and how far out, of the side that the tape is on.
  const auto seen = [&](const Vec3& p) { return Vec2(p.z(), behind * p.y()); };
  std::vector<Vec2> skin = {seen(from)};
  for (const auto& loop : plane_section(mesh, from, Vec3::UnitX())) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec3& a = loop.points[i];
      const Vec3& b = loop.points[(i + 1) % loop.points.size()];
      if (a.z() <= from.z() && a.z() >= down_to) skin.push_back(seen(a));
      if ((a.z() - down_to) * (b.z() - down_to) < 0)
        skin.push_back(seen(a + (down_to - a.z()) / (b.z() - a.z()) * (b - a)));
    }
  }
  double farthest = -std::numeric_limits<double>::infinity();
  for (const auto& p : skin) {
    if (p.x() <= down_to + 1e-9) farthest = std::max(farthest, p.y());
  }
  // Keep the chain of the hull that lies outside the line from start to end.
  const Vec2 start = seen(from), end(down_to, farthest);
  const auto outside = [&](const Vec2& p) {
    const Vec2 d = end - start, e = p - start;
    return d.x() * e.y() - d.y() * e.x() <= 1e-12;
  };
  std::vector<Vec2> kept = {start, end};
  for (const auto& p : skin) {
    if (outside(p)) kept.push_back(p);
  }
  const auto hull = convex_hull(kept);
  double perimeter = 0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    perimeter += (hull[(i + 1) % hull.size()] - hull[i]).norm();
  return perimeter - (end - start).norm();
}

}  // namespace

double back_tape(const geometry::TriangleMesh& mesh, const Vec3& from, double down_to) {
  return taut_down(mesh, from, down_to, 1);
}

double front_tape(const geometry::TriangleMesh& mesh, const Vec3& from, double down_to) {
  return taut_down(mesh, from, down_to, -1);
}

double bent_elbow_girth(const geometry::TriangleMesh& mesh, const Vec3& shoulder, const Vec3& elbow,
                        const Vec3& wrist) {
  return girth_round(mesh, elbow, (elbow - shoulder).normalized() + (wrist - elbow).normalized());
}

double neck_base_girth(const Vec3& left, const Vec3& right, const Vec3& c7, const Vec3& pit) {
  const Vec3 middle = 0.5 * (left + right);
  const double half_width = 0.5 * (left - right).norm();
  return half_ellipse(half_width, (c7 - middle).norm()) +
         half_ellipse(half_width, (pit - middle).norm());
}

Vec3 top_at(const geometry::TriangleMesh& mesh, double x, double ceiling) {
  Vec3 top(x, 0, -std::numeric_limits<double>::infinity());
  for (const auto& loop : plane_section(mesh, Vec3(x, 0, 0), Vec3::UnitX())) {
    for (const auto& p : loop.points) {
      if (p.z() <= ceiling && p.z() > top.z()) top = p;
    }
  }
  return top;
}

namespace {

std::optional<Armscye> armscye_in(const geometry::TriangleMesh& mesh, const Vec3& joint) {
  for (const auto& loop : plane_section(mesh, joint, Vec3::UnitX())) {
    if (!loop_contains(loop, Vec3::UnitX(), joint)) continue;
    const auto low = std::min_element(loop.points.begin(), loop.points.end(),
                                      [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
    return Armscye{hull_perimeter(loop.points, Vec3::UnitX()), low->z()};
  }
  return std::nullopt;
}

}  // namespace

Armscye armscye_round(const geometry::TriangleMesh& mesh, const Vec3& shoulder_joint,
                      double farthest) {
  constexpr double kStep = 0.005, kFine = 0.0005;  // [m]
  // A raised arm's underside rises less steeply than that, the side of a stout trunk more.
  constexpr double kSlope = 1.5;
  const Vec3 outwards(shoulder_joint.x() < 0 ? -1 : 1, 0, 0);
  std::optional<Armscye> highest;
  double best = 0, most = 0;
  const auto look = [&](double off) {
    const auto found = armscye_in(mesh, shoulder_joint + off * outwards);
    if (!found) return;
    const double height = found->fold - kSlope * off;
    if (!highest || height > most) highest = found, best = off, most = height;
  };
  for (double off = 0; off <= farthest; off += kStep) look(off);
  // The fold falls off steeply to either side of where trunk and arm part.
  for (double off = std::max(0.0, best - kStep), last = std::min(best + kStep, farthest);
       off <= last; off += kFine)
    look(off);
  if (!highest) throw GeometryError("body: found no closed section round the shoulder joint");
  return *highest;
}

}  // namespace loosefit::body
