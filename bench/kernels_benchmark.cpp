#include <benchmark/benchmark.h>

#include <cmath>

#include "loosefit/garment/hierarchy.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/shirt/shirt_draft.h"

namespace loosefit {
namespace {

/// Sphere of radius 0.3 m from a latitude-longitude grid, about the size and number of triangles of
/// a body.
geometry::TriangleMesh sphere(int rings, int sectors) {
  geometry::TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, -0.3);
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double polar = kPi * i / rings - kPi / 2, around = 2 * kPi * j / sectors;
      mesh.vertices.emplace_back(0.3 * std::cos(polar) * std::cos(around),
                                 0.3 * std::cos(polar) * std::sin(around), 0.3 * std::sin(polar));
    }
  mesh.vertices.emplace_back(0, 0, 0.3);
  const int top = static_cast<int>(mesh.vertices.size()) - 1;
  for (int j = 0; j < sectors; ++j) {
    const int k = (j + 1) % sectors;
    mesh.triangles.push_back({0, 1 + k, 1 + j});
    mesh.triangles.push_back({top, top - sectors + j, top - sectors + k});
    for (int i = 0; i + 2 < rings; ++i) {
      const int a = 1 + i * sectors + j, b = 1 + i * sectors + k;
      mesh.triangles.push_back({a, b, b + sectors});
      mesh.triangles.push_back({a, b + sectors, a + sectors});
    }
  }
  return mesh;
}

void closest_point(benchmark::State& state) {
  const geometry::TriangleMesh mesh = sphere(230, 230);
  const geometry::ClosestPointTree tree(mesh);
  int i = 0;
  for (auto _ : state) {
    const double t = 0.618034 * ++i;
    benchmark::DoNotOptimize(
        tree.query(Vec3(0.31 * std::cos(t), 0.31 * std::sin(t), 0.1 * std::sin(3 * t))));
  }
}
BENCHMARK(closest_point);

void closest_point_tree_build(benchmark::State& state) {
  const geometry::TriangleMesh mesh = sphere(230, 230);
  for (auto _ : state) benchmark::DoNotOptimize(geometry::ClosestPointTree(mesh));
}
BENCHMARK(closest_point_tree_build)->Unit(benchmark::kMillisecond);

void exact_self_intersections(benchmark::State& state) {
  const geometry::TriangleMesh mesh = sphere(90, 90);  // as many triangles as the reference shirt
  for (auto _ : state)
    benchmark::DoNotOptimize(geometry::self_intersections(mesh.vertices, mesh.triangles));
}
BENCHMARK(exact_self_intersections)->Unit(benchmark::kMillisecond);

void draft_and_mesh_the_shirt(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(
        garment::build_hierarchy(kinds::draft_shirt({}), 0.010, fabric::Material{}));
}
BENCHMARK(draft_and_mesh_the_shirt)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace loosefit
