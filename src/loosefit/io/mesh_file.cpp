#include "loosefit/io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/io/mesh_text.h"

namespace loosefit {
namespace {

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (auto& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

MeshFile parse(const std::string& bytes, const std::string& path) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r"))
    return mesh_text::read_ply(bytes, path);
  const std::string extension = extension_of(path);
  if (extension == ".stl") return mesh_text::read_stl(bytes, path);
  if (extension == ".obj") return mesh_text::read_obj(bytes, path);
  if (bytes.starts_with("solid")) return mesh_text::read_stl(bytes, path);
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

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), std::streamsize(bytes.size()));
  file.close();
  if (!file) throw IoError(path + ": cannot write", "is the folder there, writable, and not full?");
}

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
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
  MeshFile file = parse(bytes, path);
  if (file.mesh.vertices.empty() || file.mesh.triangles.empty()) {
    throw InvalidInput({path, 0, ""},
                       fmt::format("{} vertices and {} faces", file.mesh.vertices.size(),
                                   file.mesh.triangles.size()),
                       "a surface");
  }
  drop_degenerate(file);
  return file;
}

void write_obj(const std::string& path, const TriangleMesh& mesh,
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
  write_bytes(path, text);
}

void write_ply(const std::string& path, const TriangleMesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double "
      "y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.triangles.size());
  for (const auto& p : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) put(bytes, p[axis]);
  }
  for (const auto& t : mesh.triangles) {
    put(bytes, std::uint8_t(3));
    for (const int corner : t) put(bytes, std::int32_t(corner));
  }
  write_bytes(path, bytes);
}

void write_stl(const std::string& path, const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  put(bytes, std::uint32_t(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[std::size_t(t[0])], &b = mesh.vertices[std::size_t(t[1])],
               &c = mesh.vertices[std::size_t(t[2])];
    for (const Vec3& p : {triangle_normal(a, b, c), a, b, c}) {
      for (int axis = 0; axis < 3; ++axis) put(bytes, float(p[axis]));
    }
    put(bytes, std::uint16_t(0));
  }
  write_bytes(path, bytes);
}

}  // namespace loosefit
