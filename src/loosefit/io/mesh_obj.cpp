#include "loosefit/io/mesh_text.h"

namespace loosefit::mesh_text {

// Corner forms: 7, 7/1, 7/1/3, 7//3; a negative index counts back from the latest vertex.
MeshFile read_obj(std::string_view text, const std::string& path) {
  MeshFile file;
  Lines lines(text, path);
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "v") {
      if (words.size() < 4) lines.fail(std::to_string(words.size() - 1) + " coordinates", "three");
      file.mesh.vertices.emplace_back(lines.number_of(words[1]), lines.number_of(words[2]),
                                      lines.number_of(words[3]));
    } else if (words[0] == "f") {
      if (words.size() < 4)
        lines.fail(std::to_string(words.size() - 1) + " corners", "at least three");
      std::vector<int> corners;
      const long count = long(file.mesh.vertices.size());
      for (std::size_t i = 1; i < words.size(); ++i) {
        const long written = lines.integer_of(words[i].substr(0, words[i].find('/')));
        const long index = written < 0 ? count + written : written - 1;
        if (index < 0 || index >= count) {
          lines.fail("vertex " + std::to_string(written),
                     "a vertex from 1 to " + std::to_string(count) + " above this line");
        }
        corners.push_back(int(index));
      }
      add_polygon(corners, file.mesh);
    }
  }
  return file;
}

}  // namespace loosefit::mesh_text
