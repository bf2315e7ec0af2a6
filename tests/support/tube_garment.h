#pragma once
#include <cmath>
#include <functional>

#include "loosefit/body/body.h"
#include "loosefit/drape/drape.h"
#include "loosefit/garment/garment.h"

namespace loosefit::testing {

/// Fills the one panel of `g` with squares cut in two; id(i, j) and uv(i, j) of their corners.
template <class Id, class Uv>
void add_grid(garment::Garment& g, int columns, int rows, const Id& id, const Uv& uv) {
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      g.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      g.triangle_uv.push_back({uv(i, j), uv(i + 1, j), uv(i + 1, j + 1)});
      g.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      g.triangle_uv.push_back({uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)});
    }
  g.triangle_panel.assign(g.triangles.size(), 0);
}

/// Flat strip of `width` × `height` [m] closed to a tube along one seam: one panel "tube", u around
/// (counter-clockwise seen from above), v up. `place(u, v)` gives the 3-D position.
inline garment::Garment tube_garment(double width, double height, int around, int along) {
  garment::Garment g;
  g.panel_names = {"tube"};
  g.vertex_count = around * (along + 1);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i)
      g.vertex_uv.emplace_back(width * i / around, height * j / along);
  g.vertex_panel.assign(g.vertex_count, 0);
  const auto uv = [&](int i, int j) { return Vec2(width * i / around, height * j / along); };
  const auto id = [&](int i, int j) { return j * around + i % around; };
  add_grid(g, around, along, id, uv);
  g.area = width * height;
  return g;
}

inline drape::Drape settled_drape(const garment::Garment& garment,
                                  const std::function<Vec3(const Vec2&)>& place) {
  drape::Drape drape;
  for (const Vec2& uv : garment.vertex_uv) drape.positions.push_back(place(uv));
  drape.certificate = {1e-4, 1e-3, 0, 0, "converged"};
  return drape;
}

/// Closed upright cylinder on the axis x = y = 0 from z = 0 to `height`, one torso segment, with
/// exact smooth normals on the wall.
inline body::Body cylinder_body(double radius, double height, int around, int along) {
  body::Body body;
  auto& v = body.surface.vertices;
  auto& t = body.surface.triangles;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * kPi * i / around;
      v.emplace_back(radius * std::cos(a), radius * std::sin(a), height * j / along);
      body.normals.emplace_back(std::cos(a), std::sin(a), 0);
    }
  const auto id = [&](int i, int j) { return j * around + i % around; };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      t.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      t.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  const int bottom = static_cast<int>(v.size()), top = bottom + 1;
  v.emplace_back(0, 0, 0);
  v.emplace_back(0, 0, height);
  body.normals.emplace_back(0, 0, -1);
  body.normals.emplace_back(0, 0, 1);
  for (int i = 0; i < around; ++i) {
    t.push_back({bottom, id(i + 1, 0), id(i, 0)});
    t.push_back({top, id(i, along), id(i + 1, along)});
  }
  body.segment.assign(v.size(), body::Segment::torso);
  body.side.assign(v.size(), 0);
  return body;
}

}  // namespace loosefit::testing
