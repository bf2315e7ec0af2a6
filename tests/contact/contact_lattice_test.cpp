#include "loosefit/contact/contact_lattice.h"

#include <gtest/gtest.h>

#include <set>

#include "support/shapes.h"

namespace loosefit::contact {
namespace {

constexpr double kOffset = 2.5e-4;
constexpr int kIntervals = 4;

/// A curved sheet whose vertices are numbered from 7 on, as in a mesh of several garments.
struct Sheet {
  static constexpr int kFirst = 7;
  std::vector<Vec3> x{kFirst, Vec3(9, 9, 9)};
  std::vector<Triangle> triangles;
  std::vector<double> area;
  ContactLattice lattice = make();
  std::vector<ContactPoint> points = lattice.first_points(kOffset);

  ContactLattice make() {
    const geometry::TriangleMesh mesh = support::sheet(0.06, 0.05, 0.012, 0.2);
    x.insert(x.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (Triangle t : mesh.triangles) {
      for (int& v : t) v += kFirst;
      triangles.push_back(t);
      area.push_back(geometry::triangle_area(x[t[0]], x[t[1]], x[t[2]]));
    }
    return {triangles, area, kFirst, static_cast<int>(mesh.vertices.size()), kIntervals};
  }
  int count() const { return static_cast<int>(triangles.size()); }
  /// ∫ f over the sheet, of a function that is linear over each triangle.
  template <class F>
  double integral(const F& f) const {
    double sum = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int v : triangles[t]) sum += area[t] / 3 * f(x[v]);
    return sum;
  }
  template <class F>
  double by_points(const F& f) const {
    double sum = 0;
    for (const ContactPoint& p : points) sum += p.area * f(p.position(x));
    return sum;
  }
};

double one(const Vec3&) { return 1; }
double linear(const Vec3& p) { return 0.3 + 2 * p[0] - 5 * p[1] + 7 * p[2]; }

TEST(ContactLattice, AreasAddUpToTheClothWhateverIsRefined) {
  Sheet sheet;
  for (int t = 0; t < sheet.count(); t += 3) {
    sheet.lattice.refine(t, sheet.points);
    if (t % 2 == 0) sheet.lattice.add_nearest(t, t % 16, {0.3, 0.3, 0.4}, false, sheet.points);
    EXPECT_NEAR(sheet.by_points(one), sheet.integral(one), 1e-15);
  }
  for (const ContactPoint& p : sheet.points) EXPECT_GT(p.area, 0);
}

TEST(ContactLattice, ALinearPressureIsIntegratedExactlyOnCoarseFineAndMixedTriangles) {
  Sheet sheet;
  const double exact = sheet.integral(linear);
  EXPECT_NEAR(sheet.by_points(linear), exact, 1e-12 * std::abs(exact));
  for (int step : {3, 1}) {
    for (int t = 0; t < sheet.count(); t += step) sheet.lattice.refine(t, sheet.points);
    EXPECT_NEAR(sheet.by_points(linear), exact, 1e-12 * std::abs(exact));
  }
}

TEST(ContactLattice, HalfTheSpacingIntegratesACurvedPressureFourTimesAsExactly) {
  Sheet sheet;
  // Over one flat triangle, ∫ (b₁)² = A/6 of a corner's barycentric coordinate.
  const int t = sheet.count() / 2;
  const auto square_of_first_corner = [&] {
    double sum = 0;
    std::set<int> own;
    const Triangle& corner = sheet.triangles[t];
    for (const ContactPoint& p : sheet.points) {
      if (!p.within(corner)) continue;
      double b = 0;
      for (int k = 0; k < p.count; ++k) b += p.particle[k] == corner[0] ? p.weight[k] : 0;
      sum += p.area * b * b;
    }
    return sum;
  };
  // Only this triangle has an area.
  for (ContactPoint& p : sheet.points) p.area = 0;
  const double area = sheet.area[t];
  for (std::size_t k = 0; k < sheet.points.size(); ++k)
    if (sheet.points[k].within(sheet.triangles[t]))
      sheet.points[k].area = sheet.points[k].count == 1 ? area / 12 : area / 4;
  const double coarse = square_of_first_corner() - area / 6;
  sheet.lattice.refine(t, sheet.points);
  const double fine = square_of_first_corner() - area / 6;
  EXPECT_GT(coarse, 0.01 * area);
  EXPECT_NEAR(fine, coarse * 4 / (kIntervals * kIntervals), 1e-12 * area);
}

TEST(ContactLattice, NeighboursShareThePointsOfTheirEdgeAndNoPlaceHasTwo) {
  Sheet sheet;
  for (int t = 0; t < sheet.count(); ++t) {
    sheet.lattice.refine(t, sheet.points);
    const std::size_t points = sheet.points.size();
    sheet.lattice.refine(t, sheet.points);
    EXPECT_EQ(sheet.points.size(), points);
    EXPECT_EQ(sheet.lattice.points_of(t).size(), 15u);
  }
  for (std::size_t a = 0; a < sheet.points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      ASSERT_GT((sheet.points[a].position(sheet.x) - sheet.points[b].position(sheet.x)).norm(),
                1e-6);
}

TEST(ContactLattice, PointsStayWhereTheyAreInTheList) {
  Sheet sheet;
  const std::vector<ContactPoint> before = sheet.points;
  for (int t = 0; t < sheet.count(); ++t) sheet.lattice.refine(t, sheet.points);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(sheet.points[i].particle, before[i].particle);
    EXPECT_EQ(sheet.points[i].weight, before[i].weight);
  }
}

TEST(ContactLattice, ACellsPointLiesInItsTriangleAndMovesWithoutTakingMore) {
  Sheet sheet;
  sheet.lattice.refine(2, sheet.points);
  const auto cells = ContactLattice::cells(kIntervals);
  ASSERT_EQ(cells.size(), 16u);
  double covered = 0;
  for (const auto& cell : cells) {
    Mat3 corners;
    for (int c = 0; c < 3; ++c) corners.col(c) = Vec3(cell[c][0], cell[c][1], cell[c][2]);
    covered += std::abs(corners.determinant());  // share of the triangle
  }
  EXPECT_NEAR(covered, 1, 1e-12);
  const std::size_t before = sheet.points.size();
  sheet.lattice.add_nearest(2, 5, {0.2, 0.5, 0.3}, false, sheet.points);
  ASSERT_EQ(sheet.points.size(), before + 1);
  EXPECT_EQ(sheet.points.back().particle, sheet.triangles[2]);
  EXPECT_EQ(sheet.points.back().offset, kOffset);
  const double area = sheet.points.back().area;
  EXPECT_NEAR(area, 0.75 * sheet.area[2] / 16, 1e-18);
  sheet.lattice.add_nearest(2, 5, {0.25, 0.45, 0.3}, false, sheet.points);
  EXPECT_EQ(sheet.points.size(), before + 1);
  EXPECT_EQ(sheet.points.back().area, area);
  EXPECT_EQ(sheet.points.back().weight[0], 0.25);
  // Beside it, unless it is the same place.
  sheet.lattice.add_nearest(2, 5, {0.26, 0.44, 0.3}, true, sheet.points);
  EXPECT_EQ(sheet.points.size(), before + 1);
  EXPECT_EQ(sheet.points.back().weight[0], 0.26);
  sheet.lattice.add_nearest(2, 5, {0.25, 0.45, 0.3}, true, sheet.points);
  sheet.lattice.add_nearest(2, 5, {0.15, 0.45, 0.4}, true, sheet.points);
  EXPECT_EQ(sheet.points.size(), before + 2);
  EXPECT_EQ(sheet.points[before].weight[0], 0.25);
  EXPECT_EQ(sheet.points[before].area + sheet.points.back().area, area);
  EXPECT_EQ(sheet.lattice.points_of(2).size(), 17u);
}

}  // namespace
}  // namespace loosefit::contact
