#include "loosefit/io/mesh_obj.h"

#include <fmt/format.h>

#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/io/polygon_fan.h"
#include "loosefit/io/text_lines.h"

namespace loosefit::io {

// Corner forms: 7, 7/1, 7/1/3, 7//3; a negative index counts back from the latest vertex.
geometry::TriangleMesh parse_obj(std::string_view text, const std::string& path) {
  geometry::TriangleMesh mesh;
  TextLines lines(text, path);
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "v") {
      if (words.size() < 4) lines.fail(std::to_string(words.size() - 1) + " coordinates", "three");
      mesh.vertices.emplace_back(lines.number_of(words[1]), lines.number_of(words[2]),
                                 lines.number_of(words[3]));
    } else if (words[0] == "f") {
      if (words.size() < 4)
        lines.fail(std::to_string(words.size() - 1) + " corners", "at least three");
      std::vector<int> corners;
      const long count = long(mesh.vertices.size());
      for (std::size_t i = 1; i < words.size(); ++i) {
        const long written = lines.integer_of(words[i].substr(0, words[i].find('/')));
        const long index = written < 0 ? count + written : written - 1;
        if (index < 0 || index >= count) {
          lines.fail("vertex " + std::to_string(written),
                     "a vertex from 1 to " + std::to_string(count) + " above this line");
        }
        corners.push_back(int(index));
      }
      add_polygon(corners, mesh);
    }
  }
  return mesh;
}

void write_obj(const std::string& path, const geometry::TriangleMesh& mesh,
               const std::vector<Vec3>& normals) {
  std::string text = "# metres, z up, facing -y\n";
  for (const auto& p : mesh.vertices)
    text += fmt::format("v {:.7g} {:.7g} {:.7g}\n", p.x(), p.y(), p.z());
  for (const auto& n : normals)
    text += fmt::format("vn {:.5g} {:.5g} {:.5g}\n", n.x(), n.y(), n.z());
  for (const auto& t : mesh.triangles) {
    if (normals.empty()) {
      text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    } else {
      text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw IoError(path + ": cannot write", "is the folder there, writable, and not full?");
}

}  // namespace loosefit::io
