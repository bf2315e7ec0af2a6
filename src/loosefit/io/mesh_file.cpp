#include "loosefit/io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/io/mesh_obj.h"
#include "loosefit/io/mesh_ply.h"
#include "loosefit/io/mesh_stl.h"

namespace loosefit::io {
namespace {

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (auto& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

geometry::TriangleMesh parse(const std::string& bytes, const std::string& path) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return parse_ply(bytes, path);
  const std::string extension = extension_of(path);
  if (extension == ".stl") return parse_stl(bytes, path);
  if (extension == ".obj") return parse_obj(bytes, path);
  if (bytes.starts_with("solid")) return parse_stl(bytes, path);
  if (extension == ".ply")
    throw InvalidInput({path, 1, ""}, "something else",
                       "the word ply, with which a PLY file starts");
  throw InvalidInput({path, 0, ""}, extension.empty() ? "no extension" : "extension " + extension,
                     "an .obj, .ply or .stl surface");
}

// Scans carry slivers whose corners coincide; they have no normal and no area.
void drop_degenerate(MeshFile& file) {
  const auto before = file.mesh.triangles.size();
  std::erase_if(file.mesh.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const auto dropped = before - file.mesh.triangles.size();
  if (dropped > 0)
    file.warnings.push_back(fmt::format("{} triangles with repeated corners dropped", dropped));
}

}  // namespace

MeshFile read_mesh(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw IoError(path + ": found a folder, expected a file");
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    throw IoError(path + ": found something that is not a file, expected a readable file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw IoError(path + ": cannot read the surface", "does the file exist?");
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  MeshFile file{parse(bytes, path), {}};
  if (file.mesh.vertices.empty() || file.mesh.triangles.empty()) {
    throw InvalidInput({path, 0, ""},
                       fmt::format("{} vertices and {} faces", file.mesh.vertices.size(),
                                   file.mesh.triangles.size()),
                       "a surface");
  }
  drop_degenerate(file);
  return file;
}

}  // namespace loosefit::io
