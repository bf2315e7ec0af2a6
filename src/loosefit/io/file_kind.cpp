#include "loosefit/io/file_kind.h"

#include <cctype>
#include <cstdint>
#include <cstring>
#include <vector>

namespace loosefit::io {
namespace {

constexpr std::size_t kBeginning = 1 << 16;

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Lines without white space round them, empty ones left out.
std::vector<std::string> first_lines(const std::string& text, std::size_t count) {
  std::vector<std::string> lines;
  std::string line;
  for (const char c : text + "\n") {
    if (c != '\n' && c != '\r') {
      line += c;
      continue;
    }
    while (!line.empty() && is_space(line.back())) line.pop_back();
    line.erase(0, line.find_first_not_of(" \t"));
    if (!line.empty()) lines.push_back(line);
    if (lines.size() == count) break;
    line.clear();
  }
  return lines;
}

/// Group codes stand on lines of their own before every value; comments have the code 999.
bool is_dxf(const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    if (lines[i] == "0") return lines[i + 1] == "SECTION";
    if (lines[i] != "999") return false;
  }
  return false;
}

bool is_obj(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line[0] == '#') continue;
    const std::string word = line.substr(0, line.find_first_of(" \t"));
    if (word == "v" || word == "vn" || word == "vt") return true;
    if (word != "mtllib" && word != "o" && word != "g" && word != "s" && word != "usemtl")
      return false;
  }
  return false;
}

/// 80 free bytes, the number of triangles, 50 bytes each.
bool is_binary_stl(const std::string& bytes) {
  if (bytes.size() < 134) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return bytes.size() == 84 + std::size_t{50} * count;
}

bool has_word(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

std::string kind_of_file(const std::string& bytes) {
  std::string text = bytes.substr(0, kBeginning);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos) return "an empty file";
  // Formats that announce themselves in their first bytes.
  if (text.starts_with("%PDF-")) return "a PDF document";
  if (text.starts_with("PK\x03\x04")) return "a ZIP archive";
  if (text.starts_with("\x1f\x8b")) return "a gzip archive";
  if (text.starts_with("glTF")) return "a mesh (glTF)";
  if (text.starts_with("Kaydara FBX")) return "a mesh (FBX)";
  if (text.starts_with("\x89PNG")) return "a picture (PNG)";
  if (text.starts_with("\xff\xd8\xff")) return "a picture (JPEG)";
  if (text.starts_with("AutoCAD Binary DXF")) return "a DXF file";
  if (text.starts_with("AC10")) return "a DWG file";
  if (text.starts_with("%!PS")) return "a PostScript file";
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return "a mesh (PLY)";
  // DXF as text has no such bytes: pairs of lines, a code and a value.
  const std::vector<std::string> lines = first_lines(text, 200);
  if (is_dxf(lines)) return "a DXF file";
  // XML of all sorts, by the elements in its beginning.
  if (text[start] == '<') {
    if (has_word(text, "<svg")) return "an SVG drawing";
    if (has_word(text, "<pattern") || has_word(text, "<vit"))
      return "a Valentina or Seamly2D file (XML)";
    if (has_word(text, "<VTKFile")) return "a mesh (VTK)";
    if (has_word(text, "<COLLADA")) return "a mesh (COLLADA)";
    if (has_word(text, "<html") || has_word(text, "<!DOCTYPE html")) return "a web page";
    return "an XML file";
  }
  // JSON, by the keys in its beginning; GarmentCode itself is no other kind.
  if (text[start] == '{') {
    if (has_word(text, "\"asset\"") && has_word(text, "\"meshes\"")) return "a mesh (glTF)";
    if (has_word(text, "\"pattern\"") && has_word(text, "\"panels\"")) return {};
    if (has_word(text, "freesewing") || has_word(text, "FreeSewing") ||
        (has_word(text, "\"paths\"") && has_word(text, "\"ops\"")) ||
        (has_word(text, "\"settings\"") &&
         (has_word(text, "\"parts\"") || has_word(text, "\"patterns\"") ||
          has_word(text, "\"design\""))))
      return "a FreeSewing file";
    if (has_word(text, "\"measured\"") && has_word(text, "\"landmarks\"")) return "a body.json";
    return {};
  }
  // Meshes without a mark of their own come last: these tests may err.
  if (text.starts_with("solid") && has_word(text, "facet")) return "a mesh (STL)";
  if (is_binary_stl(bytes)) return "a mesh (STL)";
  if (is_obj(lines)) return "a mesh (OBJ)";
  return {};
}

}  // namespace loosefit::io
