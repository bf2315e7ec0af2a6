#include "loosefit/io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/mesh_obj.h"
#include "loosefit/io/mesh_ply.h"
#include "loosefit/io/mesh_stl.h"
#include "loosefit/io/text_encoding.h"
#include "loosefit/io/text_lines.h"

namespace loosefit::io {
namespace {

constexpr const char* kSurface = "a surface (OBJ, PLY or STL)";
constexpr const char *kObj = "a mesh (OBJ)", *kPly = "a mesh (PLY)", *kStl = "a mesh (STL)";

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (auto& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

constexpr const char* kExport = "export the scan as OBJ, PLY or STL";
constexpr const char* kNoFaces =
    "points without faces are no surface: mesh them first, as MeshLab does";

/// Numbers and nothing else in its first lines, three or more in each but the first.
bool is_rows_of_points(const std::string& text) {
  TextLines lines(std::string_view(text).substr(0, 2000), {});
  int rows = 0;
  for (int k = 0; k < 5 && lines.next(); ++k) {
    for (const std::string_view word : lines.words()) {
      double value = 0;
      if (!number_in(word, value)) return false;
    }
    rows += lines.words().size() >= 3;
  }
  return rows > 0;
}

/// What is no surface is named, with a way to one: what helps a reader of patterns is of no use.
void refuse_no_surface(const std::string& bytes, const std::string& path) {
  const FileKind kind = recognise_file(bytes);
  if (kind.name.empty()) {
    if (is_rows_of_points(plain_text(bytes)))
      throw InvalidInput({path, 0, ""}, "rows of numbers, a cloud of points", kSurface, kNoFaces);
    return;
  }
  std::string advice = kind.name == kUnknownBinary ? advice_by_name(path) : kind.advice;
  const auto has = [&](const char* word) { return advice.find(word) != std::string::npos; };
  if (!has("OBJ") && !has("pack") && !has("faces") && !has("file itself") && !has("again"))
    advice = kExport;
  throw InvalidInput({path, 0, ""}, kind.name, kSurface, advice);
}

geometry::TriangleMesh parse(const std::string& bytes, const std::string& path) {
  const std::string kind = kind_of_file(bytes), extension = extension_of(path);
  if (kind == kPly) return parse_ply(bytes, path);
  if (kind == kStl) return parse_stl(bytes, path);
  if (kind == kObj) return parse_obj(plain_text(bytes), path);
  // An STL that is cut off has nothing that tells it but its name.
  if (extension == ".stl" && (kind.empty() || kind == kUnknownBinary))
    return parse_stl(bytes, path);
  refuse_no_surface(bytes, path);
  if (extension == ".obj") return parse_obj(plain_text(bytes), path);
  if (bytes.starts_with("solid")) return parse_stl(bytes, path);
  if (extension == ".ply")
    throw InvalidInput({path, 1, ""}, "something else",
                       "the word ply, with which a PLY file starts");
  const std::string text = plain_text(bytes.substr(0, 1000));
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t end = std::min(text.find_first_of("\r\n", start), start + 40);
  throw InvalidInput({path, 0, ""},
                     "a file of no known kind that begins with \"" +
                         printable(text.substr(start, end - start)) + '"',
                     kSurface, kExport);
}

/// What comments of an OBJ or a PLY say of the unit, as in "# File units = inches" and in our own
/// "# metres, z up"; empty when they say nothing.
std::string stated_unit(const std::string& bytes) {
  static const std::regex comment(R"((?:#|comment\b|obj_info\b)([^\r\n]*))"),
      unit(R"(\b(?:model |file )?units?\b\s*[=:]?\s*(?:are |in )?"?([a-z]+))", std::regex::icase),
      ours(R"(^\s*(metres),)");
  const std::string head = bytes.substr(0, 4000);
  for (std::sregex_iterator at(head.begin(), head.end(), comment), end; at != end; ++at) {
    const std::string text = (*at)[1].str();
    std::smatch found;
    if (!std::regex_search(text, found, unit) && !std::regex_search(text, found, ours)) continue;
    std::string word = found[1].str();
    for (char& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [name, words] :
         {std::pair{"mm", "mm millimeter millimeters millimetre millimetres"},
          {"cm", "cm centimeter centimeters centimetre centimetres"},
          {"m", "m meter meters metre metres"},
          {"in", "in inch inches"}})
      if ((" " + std::string(words) + " ").find(" " + word + " ") != std::string::npos) return name;
  }
  return {};
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
  MeshFile file{parse(bytes, path), {}, {}};
  if (kind_of_file(bytes) != kStl) file.units = stated_unit(bytes);
  if (file.mesh.vertices.empty() || file.mesh.triangles.empty()) {
    throw InvalidInput({path, 0, ""},
                       fmt::format("{} vertices and {} faces", file.mesh.vertices.size(),
                                   file.mesh.triangles.size()),
                       "a surface", file.mesh.vertices.size() > 3 ? kNoFaces : "");
  }
  drop_degenerate(file);
  return file;
}

}  // namespace loosefit::io
