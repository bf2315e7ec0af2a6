#include "loosefit/body/catmull_clark.h"

#include <algorithm>
#include <map>

#include "loosefit/base/error.h"

namespace loosefit::body {
namespace {

struct Edge {
  int a = 0, b = 0;
  std::array<int, 2> faces = {-1, -1};
};

using Stencil = std::map<int, double>;

void add(Stencil& sum, const Stencil& part, double scale) {
  for (const auto& [index, weight] : part) sum[index] += scale * weight;
}

}  // namespace

CatmullClark::CatmullClark(int vertex_count, const std::vector<std::array<int, 4>>& quads) {
  // face_edges[f][c]: the edge from corner c to the next.
  std::vector<Edge> edges;
  std::vector<std::array<int, 4>> face_edges(quads.size());
  std::map<std::pair<int, int>, int> edge_of;
  std::map<std::pair<int, int>, int> directed;
  for (std::size_t f = 0; f < quads.size(); ++f) {
    for (std::size_t c = 0; c < 4; ++c) {
      const int a = quads[f][c], b = quads[f][(c + 1) % 4];
      const bool once = directed.emplace(std::pair(a, b), int(f)).second;
      const auto [found, added] = edge_of.emplace(std::minmax(a, b), int(edges.size()));
      if (added) edges.push_back({a, b, {-1, -1}});
      Edge& edge = edges[std::size_t(found->second)];
      if (!once || edge.faces[1] >= 0)
        throw GeometryError("subdivision: found a non-manifold quad mesh");
      edge.faces[edge.faces[0] < 0 ? 0 : 1] = int(f);
      face_edges[f][c] = found->second;
    }
  }

  // Points of faces and edges as weights of the coarse vertices.
  std::vector<Stencil> face_point(quads.size()), edge_point(edges.size());
  for (std::size_t f = 0; f < quads.size(); ++f) {
    for (const int corner : quads[f]) face_point[f][corner] += 0.25;
  }
  // What meets at a vertex: its faces' points and its edges' middles.
  struct Around {
    Stencil face_sum, edge_middle_sum;
    int valence = 0;
  };
  std::vector<Around> around(static_cast<std::size_t>(vertex_count));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Edge& edge = edges[e];
    if (edge.faces[1] < 0) throw GeometryError("subdivision: found an open quad mesh");
    for (const int end : {edge.a, edge.b}) edge_point[e][end] += 0.25;
    for (const int f : edge.faces) add(edge_point[e], face_point[std::size_t(f)], 0.25);
    for (const int end : {edge.a, edge.b}) {
      Around& here = around[std::size_t(end)];
      here.valence += 1;
      here.edge_middle_sum[edge.a] += 0.5;
      here.edge_middle_sum[edge.b] += 0.5;
    }
  }
  for (std::size_t f = 0; f < quads.size(); ++f) {
    for (const int corner : quads[f]) add(around[std::size_t(corner)].face_sum, face_point[f], 1);
  }

  // The stencils of all new points in one list: vertices, edges, faces.
  start_.push_back(0);
  const auto push = [&](const Stencil& stencil) {
    for (const auto& [index, weight] : stencil) {
      index_.push_back(index);
      weight_.push_back(weight);
    }
    start_.push_back(int(index_.size()));
  };
  for (int v = 0; v < vertex_count; ++v) {
    const Around& here = around[std::size_t(v)];
    const double n = here.valence;
    Stencil point;  // (F + 2R + (n - 3) V) / n
    add(point, here.face_sum, 1 / (n * n));
    add(point, here.edge_middle_sum, 2 / (n * n));
    point[v] += (n - 3) / n;
    push(point);
  }
  for (const auto& point : edge_point) push(point);
  for (const auto& point : face_point) push(point);

  // Each quad becomes four, cut into two triangles each.
  const int first_edge = vertex_count, first_face = vertex_count + int(edges.size());
  for (std::size_t f = 0; f < quads.size(); ++f) {
    for (std::size_t c = 0; c < 4; ++c) {
      const int corner = quads[f][c], next = first_edge + face_edges[f][c];
      const int middle = first_face + int(f), last = first_edge + face_edges[f][(c + 3) % 4];
      triangles_.push_back({corner, next, middle});
      triangles_.push_back({corner, middle, last});
    }
  }
}

std::vector<Vec3> CatmullClark::refine(const std::vector<Vec3>& coarse) const {
  std::vector<Vec3> fine(start_.size() - 1);
  for (std::size_t v = 0; v < fine.size(); ++v) {
    Vec3 sum = Vec3::Zero();
    for (int k = start_[v]; k < start_[v + 1]; ++k) {
      sum += weight_[std::size_t(k)] * coarse[std::size_t(index_[std::size_t(k)])];
    }
    fine[v] = sum;
  }
  return fine;
}

std::vector<std::pair<int, double>> CatmullClark::stencil(int fine_vertex) const {
  std::vector<std::pair<int, double>> entries;
  const auto v = std::size_t(fine_vertex);
  for (int k = start_[v]; k < start_[v + 1]; ++k) {
    entries.emplace_back(index_[std::size_t(k)], weight_[std::size_t(k)]);
  }
  return entries;
}

std::vector<Triangle> triangulate(const std::vector<std::array<int, 4>>& quads) {
  std::vector<Triangle> triangles;
  for (const auto& q : quads) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  return triangles;
}

}  // namespace loosefit::body
