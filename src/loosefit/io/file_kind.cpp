#include "loosefit/io/file_kind.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string_view>

#include "loosefit/base/error.h"
#include "loosefit/io/machine_text.h"
#include "loosefit/io/text_encoding.h"

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

/// "OFF", with letters before it for colours, normals and others.
bool is_off(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line[0] == '#') continue;
    const std::string word = line.substr(0, line.find_first_of(" \t"));
    const std::size_t letters = word.find("OFF");
    return letters != std::string::npos && letters + 3 == word.size() &&
           word.substr(0, letters).find_first_not_of("STCN4n") == std::string::npos;
  }
  return false;
}

/// Lines of 80 letters, the 73rd of them S in the first ones.
bool is_iges(const std::string& text) {
  if (text.size() < 80 || text[72] != 'S') return false;
  return text.substr(0, 80).find_first_of("\r\n") == std::string::npos &&
         text.find_first_not_of(" 0", 73) < 80 &&
         std::isdigit(static_cast<unsigned char>(text[79])) != 0;
}

/// 80 free bytes, the number of triangles, 50 bytes each.
bool is_binary_stl(const std::string& bytes) {
  if (bytes.size() < 134) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return bytes.size() == 84 + std::size_t{50} * count;
}

bool has_word(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

constexpr const char* kToMesh = "convert it to OBJ, PLY or STL";
constexpr const char* kMotion = "it moves markers or a skeleton: it holds no surface and no pieces";
constexpr const char* kPicture =
    "a picture has no measures: trace it, and save the outlines as SVG";
constexpr const char* kPoints =
    "points without faces are no surface: mesh them first, as MeshLab does";
constexpr const char* kProject =
    "export the pattern there as DXF (AAMA or ASTM), or the avatar as OBJ";
constexpr const char* kPlot = "export the pattern as DXF-AAMA or SVG instead";
constexpr const char* kPrint = "a plot or print file (PCL)";
constexpr const char* kUnpack = "unpack it and name a file in it";
constexpr const char* kTable = "save its table as CSV UTF-8";

/// A format that announces itself in its first bytes.
struct Signature {
  std::string_view bytes;
  std::size_t offset;
  const char *name, *advice;
};

using namespace std::string_view_literals;

constexpr Signature kSignatures[] = {
    {"%PDF-"sv, 0, "a PDF document", kPlot},
    {"%!PS"sv, 0, "a PostScript file", kPlot},
    {"\xc5\xd0\xd3\xc6"sv, 0, "a PostScript file", kPlot},
    {"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, 0, "an Office document (xls, doc)", kTable},
    {"\x1f\x8b"sv, 0, "a gzip archive", kUnpack},
    {"7z\xbc\xaf\x27\x1c"sv, 0, "a 7z archive", kUnpack},
    {"Rar!\x1a\x07"sv, 0, "a RAR archive", kUnpack},
    {"BZh"sv, 0, "a bzip2 archive", kUnpack},
    {"\xfd\x37zXZ\0"sv, 0, "an xz archive", kUnpack},
    {"glTF"sv, 0, "a mesh (glTF)", kToMesh},
    {"Kaydara FBX"sv, 0, "a mesh (FBX)", kToMesh},
    {"; FBX "sv, 0, "a mesh (FBX)", kToMesh},
    {"BLENDER"sv, 0, "a Blender file", kToMesh},
    {"\x28\xb5\x2f\xfd"sv, 0, "a compressed Blender file or another Zstandard file", kToMesh},
    {"#usda"sv, 0, "a mesh (USD)", kToMesh},
    {"PXR-USDC"sv, 0, "a mesh (USD)", kToMesh},
    {"Ogawa"sv, 0, "a mesh (Alembic)", kToMesh},
    {"#VRML"sv, 0, "a mesh (VRML)", kToMesh},
    {"# vtk DataFile"sv, 0, "a mesh (VTK)", kToMesh},
    {"//Maya ASCII"sv, 0, "a Maya file", kToMesh},
    {"ISO-10303-21;"sv, 0, "a CAD model (STEP)", kToMesh},
    {"\x89PNG"sv, 0, "a picture (PNG)", kPicture},
    {"\xff\xd8\xff"sv, 0, "a picture (JPEG)", kPicture},
    {"GIF8"sv, 0, "a picture (GIF)", kPicture},
    {"II*\0"sv, 0, "a picture (TIFF)", kPicture},
    {"MM\0*"sv, 0, "a picture (TIFF)", kPicture},
    {"ftyphei"sv, 4, "a picture (HEIC)", kPicture},
    {"ftyp"sv, 4, "a film (MP4)", "it holds no surface and no pieces"},
    {"AutoCAD Binary DXF"sv, 0, "a DXF file", ""},
    {"AC10"sv, 0, "a DWG file", "export it as ASCII DXF"},
    {"\x93NUMPY"sv, 0, "an array of NumPy", kToMesh},
    {"\x89HDF\r\n"sv, 0, "an HDF5 file", ""},
    {"\x80\x02"sv, 0, "a pickle of Python", kToMesh},
    {"\x80\x03"sv, 0, "a pickle of Python", kToMesh},
    {"\x80\x04\x95"sv, 0, "a pickle of Python", kToMesh},
    {"\x80\x05\x95"sv, 0, "a pickle of Python", kToMesh},
    {"MATLAB 5.0 MAT-file"sv, 0, "a MATLAB file", ""},
    {"OCTM"sv, 0, "a mesh (CTM)", kToMesh},
    {"DRACO"sv, 0, "a mesh (Draco)", kToMesh},
    {"\x02\0\n\0\0\0"sv, 6, "a mesh (3DS)", kToMesh},
    {"LWO"sv, 8, "a mesh (LightWave)", kToMesh},
    {"QC4DC4D6"sv, 0, "a Cinema 4D file", kToMesh},
    {"FOR4"sv, 0, "a Maya file", kToMesh},
    {"FOR8"sv, 0, "a Maya file", kToMesh},
    {"3D Geometry File Format"sv, 0, "a Rhino file (3DM)", kToMesh},
    {"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h"sv, 0, "a SketchUp file", kToMesh},
    {"# .PCD"sv, 0, "a cloud of points (PCD)", kPoints},
    {"\xd7\xcd\xc6\x9a"sv, 0, "a picture (WMF)", kPlot},
    {" EMF"sv, 40, "a picture (EMF)", kPlot},
    {"ASTM/D13Proposal"sv, 0, "a table of grade rules (RUL)",
     "it belongs to a DXF file, which holds the pieces: name that"},
    {"#PES"sv, 0, "an embroidery (PES)", kPlot},
    {"#PEC"sv, 0, "an embroidery (PEC)", kPlot},
    {"LA:"sv, 0, "an embroidery (DST)", kPlot},
    {"\x1b%"sv, 0, "a plot file (HPGL)", kPlot},
    {"\x1b."sv, 0, "a plot file (HPGL)", kPlot},
    {"\x1b"
     "E"sv,
     0, kPrint, kPlot},
    {"\x1b("sv, 0, kPrint, kPlot},
    {"\x1b&"sv, 0, kPrint, kPlot},
    {"\x1b*"sv, 0, kPrint, kPlot},
    {"\x02P"sv, 0, "a motion (C3D)", kMotion},
    {"SQLite format 3"sv, 0, "a database (SQLite)", ""},
    {"version https://git-lfs.github.com"sv, 0, "a Git LFS pointer, not the file it stands for",
     "run `git lfs pull` where it was cloned, or download the file itself"},
    {"HIERARCHY"sv, 0, "a motion (BVH)", kMotion},
    {"PathFileType"sv, 0, "a motion (TRC)", kMotion},
    {"ply\n"sv, 0, "a mesh (PLY)", ""},
    {"ply\r"sv, 0, "a mesh (PLY)", ""},
};

/// Formats that are chunks of RIFF.
FileKind in_riff(const std::string& text) {
  if (text.compare(8, 4, "WEBP") == 0) return {"a picture (WebP)", kPicture};
  if (text.compare(8, 3, "CDR") == 0) return {"a CorelDRAW file", kPlot};
  return {"a film or sound (RIFF)", ""};
}

/// Formats that are a ZIP archive inside, told by the names of their parts.
FileKind in_zip(const std::string& text) {
  if (has_word(text, "xl/")) return {"an Excel workbook (xlsx)", kTable};
  if (has_word(text, "word/")) return {"a Word document (docx)", kTable};
  if (has_word(text, "opendocument.spreadsheet")) return {"a spreadsheet (ods)", kTable};
  if (has_word(text, "opendocument.")) return {"an OpenDocument file", ""};
  if (has_word(text, "3D/3dmodel")) return {"a mesh (3MF)", kToMesh};
  if (has_word(text, ".zpac") || has_word(text, ".avt") || has_word(text, ".zprj"))
    return {"a project of CLO or Marvelous Designer", kProject};
  if (has_word(text, ".usda") || has_word(text, ".usdc")) return {"a mesh (USD)", kToMesh};
  if (has_word(text, ".npy")) return {"arrays of NumPy (npz)", kToMesh};
  if (has_word(text, "ppt/")) return {"a PowerPoint document (pptx)", kPlot};
  if (has_word(text, "document.json") && has_word(text, "pages/"))
    return {"a drawing of Sketch", kPlot};
  if (has_word(text, "Index/") && has_word(text, ".iwa")) return {"a document of iWork", kTable};
  return {"a ZIP archive", kUnpack};
}

/// Name of the first element of XML or HTML in small letters, without its prefix.
std::string root_name(const std::string& text, std::size_t at) {
  while ((at = text.find('<', at)) != std::string::npos) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
    } else if (text.compare(at, 2, "<?") != 0 && text.compare(at, 2, "<!") != 0) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n/>", at + 1), text.size());
      const std::string name = lower(text.substr(at + 1, end - at - 1));
      return name.substr(name.find(':') == std::string::npos ? 0 : name.find(':') + 1);
    }
    if (at == std::string::npos) break;
    ++at;
  }
  return {};
}

FileKind in_xml(const std::string& text, std::size_t start) {
  const std::string root = root_name(text, start);
  if (root == "svg") return {"an SVG drawing", ""};
  if (root == "html" || lower(text.substr(start, 14)) == "<!doctype html")
    return {"a web page", "save the file itself, not the page that shows it"};
  if (root == "pattern") return {"a Valentina or Seamly2D file (XML)", ""};
  if (root == "vit" || root == "vst" || root == "smis" || root == "smms")
    return {"measures of Valentina or Seamly2D (XML)",
            "they belong to a pattern (.val, .sm2d), which names them: name that"};
  if (root == "vtkfile") return {"a mesh (VTK)", kToMesh};
  if (root == "collada") return {"a mesh (COLLADA)", kToMesh};
  if (root == "x3d") return {"a mesh (X3D)", kToMesh};
  if (root == "opensimdocument") return {"a model of OpenSim", kMotion};
  // A document type with entities may fill the beginning.
  if (has_word(text, "<svg")) return {"an SVG drawing", ""};
  return {"an XML file", ""};
}

bool has_keys(const std::string& text, std::initializer_list<const char*> keys) {
  return std::all_of(keys.begin(), keys.end(),
                     [&](const char* key) { return has_word(text, '"' + std::string(key) + '"'); });
}

/// JSON, by the keys in its beginning; GarmentCode itself is no other kind.
FileKind in_json(const std::string& text) {
  if (has_keys(text, {"asset"}) && (has_keys(text, {"meshes"}) || has_keys(text, {"nodes"}) ||
                                    has_keys(text, {"scenes"}) || has_keys(text, {"buffers"})))
    return {"a mesh (glTF)", kToMesh};
  if (has_keys(text, {"metadata", "geometries"})) return {"a mesh (three.js)", kToMesh};
  if (has_keys(text, {"pattern", "panels"})) return {};
  if (has_word(text, "freesewing") || has_word(text, "FreeSewing") ||
      has_keys(text, {"paths", "ops"}) ||
      (has_keys(text, {"settings"}) &&
       (has_keys(text, {"parts"}) || has_keys(text, {"patterns"}) || has_keys(text, {"design"}))))
    return {"a FreeSewing file", ""};
  if (has_keys(text, {"measured", "landmarks"})) return {"a body.json", ""};
  if (has_keys(text, {"FeatureCollection"}) || has_keys(text, {"Feature", "geometry"}))
    return {"a map (GeoJSON)", ""};
  if (has_keys(text, {"nbformat", "cells"})) return {"a notebook (Jupyter)", ""};
  if (has_keys(text, {"layers", "fr", "op"})) return {"an animation (Lottie)", ""};
  if (has_keys(text, {"version"}) &&
      (has_keys(text, {"dependencies"}) || has_keys(text, {"devDependencies"}) ||
       has_keys(text, {"scripts"}) || has_keys(text, {"lockfileVersion"})))
    return {"a package.json of Node", ""};
  return {};
}

/// Whether a bracket opens a list of JSON, and not a section of TOML.
bool is_json_list(const std::string& text, std::size_t start) {
  std::size_t at = start;
  while (at < text.size() && (text[at] == '[' || is_space(text[at]))) ++at;
  if (at == text.size()) return false;
  const char c = text[at];
  const auto digit = [](char d) { return std::isdigit(static_cast<unsigned char>(d)) != 0; };
  if (c == '{' || (c == ']' && text.find('=') == std::string::npos)) return true;
  if (c == '-') return at + 1 < text.size() && digit(text[at + 1]);
  return (c == '"' || digit(c)) && text.find('=') == std::string::npos;
}

bool is_key(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.' ||
           c == '"' || c == ' ';
  });
}

bool is_toml(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line[0] == '#') continue;
    if (line.starts_with("sep=")) return false;  // a table of Excel
    if (line[0] == '[') return line.find(']') != std::string::npos && !is_json_list(line, 0);
    const std::size_t equal = line.find('=');
    return equal != std::string::npos && is_key(line.substr(0, equal));
  }
  return false;
}

bool is_yaml(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (line[0] == '#') continue;
    if (line == "---" || line.starts_with("%YAML")) return true;
    return line.back() == ':' && is_key(line.substr(0, line.size() - 1)) && lines.size() > 1;
  }
  return false;
}

/// Windows bitmaps have four zeros after the length.
bool is_bitmap(const std::string& bytes) {
  return bytes.size() > 18 && bytes.starts_with("BM") &&
         bytes.compare(6, 4, std::string(4, '\0')) == 0 && bytes[14] != 0;
}

bool is_binary(const std::string& text) {
  const std::string_view some = std::string_view(text).substr(0, 4096);
  return some.find('\0') != std::string_view::npos;
}

}  // namespace

FileKind recognise_file(const std::string& bytes) {
  for (const Signature& s : kSignatures)
    if (bytes.size() >= s.offset + s.bytes.size() &&
        std::string_view(bytes).substr(s.offset, s.bytes.size()) == s.bytes)
      return {s.name, s.advice};
  if (is_bitmap(bytes)) return {"a picture (BMP)", kPicture};
  if (bytes.starts_with("RIFF") && bytes.size() > 12) return in_riff(bytes.substr(0, 12));
  if (bytes.starts_with("PK\x03\x04")) return in_zip(bytes.substr(0, kBeginning));
  const std::string text = plain_text(bytes.substr(0, kBeginning));
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos)
    return {"an empty file", "save it again, or fetch it again where it came from"};
  // DXF as text has no first bytes of its own: pairs of lines, a code and a value.
  const std::vector<std::string> lines = first_lines(text, 200);
  if (is_dxf(lines)) return {"a DXF file", ""};
  if (text[start] == '<') return in_xml(text, start);
  if (text[start] == '{') return in_json(text);
  if (text[start] == '[' && is_json_list(text, start)) {
    const FileKind inner = in_json(text);
    return inner.name.empty() ? FileKind{"a JSON list", ""} : inner;
  }
  // Meshes and others without a mark of their own come last: these tests may err.
  if (text.starts_with("solid") && has_word(text, "facet")) return {"a mesh (STL)", ""};
  if (is_binary_stl(bytes)) return {"a mesh (STL)", ""};
  if (is_obj(lines)) return {"a mesh (OBJ)", ""};
  if (has_word(text, "endheader") && has_word(text, "nRows"))
    return {"a motion (OpenSim)", kMotion};
  if (is_off(lines)) return {"a mesh (OFF)", kToMesh};
  if (is_iges(text)) return {"a CAD model (IGES)", kToMesh};
  if (const std::string language = machine_language(text); !language.empty())
    return {language, kPlot};
  if (is_toml(lines)) return {"a TOML file", ""};
  if (is_yaml(lines)) return {"a YAML file", ""};
  if (is_binary(text)) return {kUnknownBinary, ""};
  return {};
}

std::string advice_by_name(const std::string& file) {
  constexpr struct {
    std::string_view endings;  ///< a stroke before and behind each
    const char* program;
  } kProjects[] = {{"|zprj|zpac|pac|avt|avac|zfab|", "CLO or Marvelous Designer"},
                   {"|mdl|iba|vet|mdlx|plx|", "Lectra"},
                   {"|pds|dsn|dsp|mrk|", "Optitex"},
                   {"|tmp|pce|sty|", "Gerber AccuMark"},
                   {"|bw|vsgx|", "Browzwear"},
                   {"|prjx|sproj|zst|", "Style3D"},
                   {"|gemini|gem|", "Gemini"},
                   {"|ptn|pat|", "Audaces or PatternMaker"},
                   {"|max|", "3ds Max"},
                   {"|ztl|zpr|", "ZBrush"},
                   {"|studio|studio3|", "Silhouette Studio"}};
  const std::size_t dot = file.rfind('.');
  if (dot == std::string::npos || file.find('/', dot) != std::string::npos) return {};
  const std::string ending = '|' + lower(file.substr(dot + 1)) + '|';
  for (const auto& [endings, program] : kProjects)
    if (endings.find(ending) != std::string_view::npos)
      return std::string("by its name it is a file of ") + program + ": " + kProject;
  return {};
}

std::string kind_of_file(const std::string& bytes) { return recognise_file(bytes).name; }

void refuse_other_kinds(const std::string& bytes, const std::string& file,
                        const std::string& expected, const std::vector<std::string>& read_here,
                        const std::string& hint) {
  FileKind kind = recognise_file(bytes);
  if (kind.name == kUnknownBinary) kind.advice = advice_by_name(file);
  if (kind.name.empty() ||
      std::find(read_here.begin(), read_here.end(), kind.name) != read_here.end())
    return;
  throw InvalidInput({file, 0, {}}, kind.name, expected,
                     kind.advice + (kind.advice.empty() || hint.empty() ? "" : "; ") + hint);
}

}  // namespace loosefit::io
