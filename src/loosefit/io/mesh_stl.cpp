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

std::uint32_t announced(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

/// Whether it reads as text: a binary file has zeros in its first numbers.
bool is_text(std::string_view bytes) {
  return bytes.substr(0, 1000).find('\0') == std::string_view::npos;
}

std::string after(const geometry::TriangleMesh& mesh) {
  return "after " + std::to_string(mesh.triangles.size()) + " triangles";
}

/// \throws InvalidInput, always, with what is wrong with a binary file of that length.
[[noreturn]] void refuse_length(std::string_view bytes, const std::string& path) {
  if (bytes.size() < kHeaderBytes)
    throw InvalidInput({path, 0, ""}, std::to_string(bytes.size()) + " bytes",
                       "a binary STL, whose head alone has 84",
                       "the file is cut off: copy or export it again");
  const std::size_t room = (bytes.size() - kHeaderBytes) / kTriangleBytes;
  const std::uint32_t count = announced(bytes);
  throw InvalidInput(
      {path, 0, ""},
      std::to_string(count) + " triangles announced, bytes for " + std::to_string(room),
      "a binary STL with 50 bytes for each triangle",
      room < count ? "the file is cut off, or no STL: copy or export it again"
                   : "the file was changed on its way, as by a copy in text mode: copy it again");
}

}  // namespace

geometry::TriangleMesh parse_stl(std::string_view bytes, const std::string& path) {
  // A binary file says its own length; its header may start with "solid" too.
  if (bytes.size() >= kHeaderBytes &&
      bytes.size() == kHeaderBytes + announced(bytes) * kTriangleBytes)
    return parse_binary(bytes, path, announced(bytes));
  if (!is_text(bytes)) refuse_length(bytes, path);
  geometry::TriangleMesh mesh;
  Welder weld(mesh);
  TextLines lines(bytes, path);
  std::vector<int> corners;
  bool solid = false, ended = false;
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "solid") solid = true, ended = false;
    if (!solid) lines.fail("something else", "a binary STL of the length it states, or \"solid\"");
    ended = ended || words[0] == "endsolid";
    if (words[0] == "vertex") {
      // The last line of a file that is cut off may end within a number.
      if (lines.at_end())
        lines.fail_cut_off(after(mesh), "endloop, endfacet and endsolid behind its corners");
      if (words.size() != 4) lines.fail(std::to_string(words.size() - 1) + " coordinates", "three");
      corners.push_back(weld.vertex(
          {lines.number_of(words[1]), lines.number_of(words[2]), lines.number_of(words[3])}));
    } else if (words[0] == "endloop") {
      if (corners.size() < 3) lines.fail(std::to_string(corners.size()) + " corners", "three");
      add_polygon(corners, mesh);
      corners.clear();
    }
  }
  if (!corners.empty()) lines.fail_cut_off(after(mesh), "endloop");
  if (!ended) lines.fail_cut_off(after(mesh), "endsolid");
  return mesh;
}

}  // namespace loosefit::io
