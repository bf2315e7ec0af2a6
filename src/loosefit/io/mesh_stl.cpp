#include "loosefit/io/mesh_stl.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/io/polygon_fan.h"
#include "loosefit/io/text_lines.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;

/// STL repeats every corner: equal coordinates become one vertex.
class Welder {
 public:
  explicit Welder(geometry::TriangleMesh& mesh) : mesh_(mesh) {}
  int vertex(const Vec3& p) {
    const auto [found, added] = index_.emplace(
        std::array<double, 3>{p.x() + 0., p.y() + 0., p.z() + 0.}, int(mesh_.vertices.size()));
    if (added) mesh_.vertices.push_back(p);
    return found->second;
  }

 private:
  geometry::TriangleMesh& mesh_;
  std::map<std::array<double, 3>, int> index_;
};

geometry::TriangleMesh parse_binary(std::string_view bytes, const std::string& path,
                                    std::uint32_t count) {
  geometry::TriangleMesh mesh;
  Welder weld(mesh);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<float, 9> corner;
    std::memcpy(corner.data(), bytes.data() + kHeaderBytes + t * kTriangleBytes + 12,
                sizeof corner);
    Triangle triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 p(corner[3 * c], corner[3 * c + 1], corner[3 * c + 2]);
      if (!(p.cwiseAbs().maxCoeff() < 1e9)) {
        throw InvalidInput({path, 0, "triangle " + std::to_string(t)},
                           "a coordinate that is not finite", "a number");
      }
      triangle[c] = weld.vertex(p);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace

geometry::TriangleMesh parse_stl(std::string_view bytes, const std::string& path) {
  // A binary file says its own length; its header may start with "solid" too.
  if (bytes.size() >= kHeaderBytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    if (bytes.size() == kHeaderBytes + count * kTriangleBytes)
      return parse_binary(bytes, path, count);
  }
  geometry::TriangleMesh mesh;
  Welder weld(mesh);
  TextLines lines(bytes, path);
  std::vector<int> corners;
  bool solid = false;
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "solid") solid = true;
    if (!solid) lines.fail("something else", "a binary STL of the length it states, or \"solid\"");
    if (words[0] == "vertex") {
      if (words.size() != 4) lines.fail(std::to_string(words.size() - 1) + " coordinates", "three");
      corners.push_back(weld.vertex(
          {lines.number_of(words[1]), lines.number_of(words[2]), lines.number_of(words[3])}));
    } else if (words[0] == "endloop") {
      if (corners.size() < 3) lines.fail(std::to_string(corners.size()) + " corners", "three");
      add_polygon(corners, mesh);
      corners.clear();
    }
  }
  if (!corners.empty()) lines.fail("the end of the file", "endloop");
  return mesh;
}

}  // namespace loosefit::io
