#include "loosefit/io/file_kind.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/io/garmentcode_read.h"

namespace loosefit::io {
namespace {

std::string refusal(const std::string& bytes) {
  try {
    parse_garmentcode(bytes, "x");
  } catch (const Error& error) {
    return error.what();
  }
  return "read";
}

TEST(FileKind, IsToldByTheContent) {
  std::string stl(84, ' ');
  stl[80] = 2, stl[81] = stl[82] = stl[83] = 0;
  stl += std::string(100, '\0');
  const std::vector<std::pair<std::string, std::string>> files = {
      {"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "a DXF file"},
      {"999\nmade by x\n0\nSECTION\n2\nBLOCKS\n", "a DXF file"},
      {"<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">", "an SVG drawing"},
      {"\xef\xbb\xbf<svg>", "an SVG drawing"},
      {"<?xml version='1.0'?><pattern><version>0.8</version>",
       "a Valentina or Seamly2D file (XML)"},
      {"{\"settings\": {\"measurements\": {}}, \"design\": \"brian\"}", "a FreeSewing file"},
      {"{\"settings\": [{}], \"parts\": [{}], \"stacks\": {}}", "a FreeSewing file"},
      {"# Blender\nmtllib a.mtl\no Cube\nv 1 1 -1\n", "a mesh (OBJ)"},
      {"ply\nformat ascii 1.0\n", "a mesh (PLY)"},
      {"solid a\n facet normal 0 0 1\n", "a mesh (STL)"},
      {stl, "a mesh (STL)"},
      {std::string("glTF\x02\0\0\0", 8), "a mesh (glTF)"},
      {"{\"asset\": {\"version\": \"2.0\"}, \"meshes\": []}", "a mesh (glTF)"},
      {"%PDF-1.7\n", "a PDF document"},
      {std::string("PK\x03\x04\x14\0", 6), "a ZIP archive"},
      {"", "an empty file"},
      {" \n\t", "an empty file"},
  };
  for (const auto& [bytes, kind] : files) {
    EXPECT_EQ(kind_of_file(bytes), kind);
    EXPECT_EQ(refusal(bytes),
              "x: found " + kind + ", expected GarmentCode JSON (NAME_specification.json)");
  }
}

std::string in_utf16(const std::string& ascii, bool little) {
  std::string bytes = little ? "\xff\xfe" : "\xfe\xff";
  for (const char c : ascii) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

TEST(FileKind, FilesOfOtherProgramsAreNamedWithWhatToDo) {
  const std::vector<std::array<std::string, 3>> files = {
      {"HIERARCHY\nROOT hip\n", "a motion (BVH)", "no surface"},
      {"PathFileType\t4\t(X/Y/Z)\twalk.trc\n", "a motion (TRC)", "no surface"},
      {std::string("\x02P\x10\0\0\0", 6), "a motion (C3D)", "no surface"},
      {"Coordinates\nversion=1\nnRows=3\nendheader\n", "a motion (OpenSim)", "no surface"},
      {"IN;SP1;PU0,0;PD4000,0;PU;", "a plot file (HPGL)", "DXF"},
      {"\x1b%-12345X@PJL ENTER LANGUAGE=HPGL2", "a plot file (HPGL)", "DXF"},
      {"PA;PU0 0;PD40 0 40 40;", "a plot file (HPGL)", "DXF"},
      {"%!PS-Adobe-3.0 EPSF\n", "a PostScript file", "SVG"},
      {"\x89PNG\r\n\x1a\n", "a picture (PNG)", "trace"},
      {"\xff\xd8\xff\xe0", "a picture (JPEG)", "trace"},
      {"GIF89a", "a picture (GIF)", "trace"},
      {"RIFF1234WEBPVP8 ", "a picture (WebP)", "trace"},
      {"PK\x03\x04....[Content_Types].xml....xl/workbook.xml", "an Excel workbook (xlsx)", "CSV"},
      {"PK\x03\x04....word/document.xml", "a Word document (docx)", "CSV"},
      {"PK\x03\x04mimetypeapplication/vnd.oasis.opendocument.spreadsheet", "a spreadsheet (ods)",
       "CSV"},
      {"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "an Office document (xls, doc)", "CSV"},
      {"Kaydara FBX Binary  ", "a mesh (FBX)", ""},
      {"; FBX 7.4.0 project file\n", "a mesh (FBX)", ""},
      {"BLENDER-v300", "a Blender file", "OBJ"},
      {"ISO-10303-21;\nHEADER;\n", "a CAD model (STEP)", "OBJ"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:1\n",
       "a Git LFS pointer, not the file it stands for", "git lfs pull"},
      {"<!doctype html>\n<html><svg></svg></html>", "a web page", "the file itself"},
      {"<HTML><head>", "a web page", "the file itself"},
      {"<!-- x --><html>", "a web page", "the file itself"},
      {"[{\"a\": 1}]", "a JSON list", ""},
      {"[[0, 1], [2, 3]]", "a JSON list", ""},
      {"[\"a\", \"b\"]", "a JSON list", ""},
      {"{\"type\": \"FeatureCollection\", \"features\": []}", "a map (GeoJSON)", ""},
      {"{\"name\": \"x\", \"version\": \"1.0.0\", \"dependencies\": {}}", "a package.json of Node",
       ""},
      {"{\"v\": \"5.5\", \"fr\": 30, \"ip\": 0, \"op\": 60, \"layers\": []}",
       "an animation (Lottie)", ""},
      {"[garment]\npattern = \"t-shirt\"\n", "a TOML file", ""},
      {"# case\nname = 1\n", "a TOML file", ""},
      {"[[axis]]\nname = \"people\"\n", "a TOML file", ""},
      {"body:\n  height: 171\n  waist: 84\n", "a YAML file", ""},
      {std::string("ab\0\1\2cdef", 9), kUnknownBinary, ""},
  };
  for (const auto& [bytes, kind, advice] : files) {
    SCOPED_TRACE(kind);
    EXPECT_EQ(recognise_file(bytes).name, kind);
    EXPECT_NE(recognise_file(bytes).advice.find(advice), std::string::npos);
    EXPECT_NE(refusal(bytes).find("x: found " + kind), std::string::npos) << refusal(bytes);
    // A byte order mark and UTF-16 hide no text.
    if (bytes.find_first_of(std::string("\0\x80\xff\xd0\x89\x1b", 6)) == std::string::npos &&
        (bytes[0] == '<' || bytes[0] == '{' || bytes[0] == '[' || bytes[0] == '#')) {
      EXPECT_EQ(kind_of_file("\xef\xbb\xbf" + bytes), kind);
      for (const bool little : {false, true})
        EXPECT_EQ(kind_of_file(in_utf16(bytes, little)), kind);
    }
  }
}

TEST(FileKind, LanguagesOfMachinesAreToldFromTextsOfAnyMoves) {
  std::mt19937 draw(65);
  std::uniform_int_distribution<int> number(-9999, 9999), few(2, 30);
  for (int k = 0; k < 40; ++k) {
    std::string plot = k % 2 ? "IN;SP1;" : "\nBP5,1;IN;PA;",
                g = k % 2 ? "%\nO12\nG21 G90\n" : "(cut)\nN10 G21\nM3 S100\n",
                cut = "H1*M20*N1*M15*";
    for (int n = few(draw); n > 0; --n) {
      const int x = number(draw), y = number(draw);
      plot += fmt::format("PU{},{};PD{},{},{},{};", x, y, y, x, x, x);
      g += fmt::format("{} X{}.5 Y{}\n", n % 3 ? "G1" : "G00", x, y);
      cut += fmt::format("X{}Y{}*{}*", x, y, n % 2 ? "M14" : "M15");
    }
    EXPECT_EQ(kind_of_file(plot), "a plot file (HPGL)") << plot;
    EXPECT_EQ(kind_of_file(plot + "LBFront piece\3PU;SP0;"), "a plot file (HPGL)") << plot;
    EXPECT_EQ(kind_of_file(g), "a machine program (G-code)") << g;
    EXPECT_EQ(kind_of_file(cut + "M0*"), "a cutter file (Gerber, ISO 6983)") << cut;
    std::string small = plot;
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_EQ(kind_of_file(small), "a plot file (HPGL)") << small;
    EXPECT_EQ(kind_of_file("\x1b"
                           "E\x1b%0B" +
                           plot)
                  .find("a plot"),
              0u);
  }
  EXPECT_EQ(kind_of_file("%FSLAX24Y24*%\n%MOMM*%\nG01*\n"), "a photoplot (Gerber RS-274X)");
  for (const char* text : {"name,x\nA,1\n", "INSIDE;PD", "x 1 2\n", "G is a letter\n", "M1\n",
                           "38,40,42\n", "X1,Y2\n1,2\n"})
    EXPECT_EQ(kind_of_file(text), "") << text;
}

TEST(FileKind, MeshesModelsAndProjectsAreNamed) {
  using namespace std::string_literals;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"OFF\n4 4 6\n0 0 0\n", "a mesh (OFF)"},
      {"OFF 4 4 6\n0 0 0\n", "a mesh (OFF)"},
      {"# made by x\nCOFF\n4 4 6\n", "a mesh (OFF)"},
      {"{\"asset\": {\"version\": \"2.0\"}, \"nodes\": []}", "a mesh (glTF)"},
      {"MM\x10\0\0\0\x02\0\n\0\0\0"s, "a mesh (3DS)"},
      {std::string(72, ' ') + "S      1\n", "a CAD model (IGES)"},
      {"3D Geometry File Format        7", "a Rhino file (3DM)"},
      {"\x93NUMPY\1\0"s, "an array of NumPy"},
      {"PK\x03\x04....garment.zpac....avatar.avt", "a project of CLO or Marvelous Designer"},
      {"PK\x03\x04....3D/3dmodel.model", "a mesh (3MF)"},
      {"PK\x03\x04....mesh.usdc", "a mesh (USD)"},
      {"BM\x36\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\0"s, "a picture (BMP)"},
      {"# .PCD v.7\nVERSION .7\n", "a cloud of points (PCD)"},
      {"ASTM/D13Proposal 1 Version: D 6673-04\n", "a table of grade rules (RUL)"},
      {"<?xml version=\"1.0\"?><smis><unit>cm</unit></smis>",
       "measures of Valentina or Seamly2D (XML)"},
  };
  for (const auto& [bytes, kind] : files) EXPECT_EQ(kind_of_file(bytes), kind);
}

TEST(FileKind, UnknownTextsAndBinaryFilesAreNotCalledBadJson) {
  for (const auto& [name, bytes, words] :
       {std::array<std::string, 3>{"x.txt", "hello world\n", "begins with \"hello world\""},
        {"x.MDL", std::string("\1\2MDL\0\0", 7), "binary data"},
        {"x.zprj", "ZPRJ 4 something\n", "begins with"}})
    try {
      parse_garmentcode(bytes, name);
      FAIL();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("syntax"), std::string::npos);
      const std::string program = name == "x.MDL" ? "Lectra" : name == "x.zprj" ? "CLO" : "DXF";
      EXPECT_NE(error.hint().find(program), std::string::npos) << error.hint();
    }
}

TEST(FileKind, JsonOfOtherProgramsIsToldByItsKeys) {
  EXPECT_EQ(
      refusal("{\"pieces\": {\"F\": {}}, \"unit\": 1}"),
      "x: found JSON of another program (keys \"pieces\", \"unit\"), expected GarmentCode JSON "
      "(NAME_specification.json)");
  EXPECT_NE(refusal("{}").find("a JSON object without keys"), std::string::npos);
  EXPECT_NE(refusal("{\"pattern\": {}}").find("pattern.panels"), std::string::npos);
}

TEST(FileKind, TextsOfOursAreNoOtherKind) {
  for (const char* text :
       {"name,sex,age,height\nA,female,30,1.7\n", "name;sex\nA;f\n", "0.1 0.2 0.3\n",
        "IN a word; PU 1", "INSIDE;PD", "1;2;3\n", "sep=;\nname;sex\n", "{\"chest\": 0.9}"})
    EXPECT_EQ(kind_of_file(text), "") << text;
}

TEST(FileKind, PatternsAndBrokenPatternsHaveNone) {
  EXPECT_EQ(kind_of_file("{\"pattern\": {\"panels\": {}}}"), "");
  EXPECT_EQ(kind_of_file("{\"pattern\": {\"panels\": "), "");
  EXPECT_EQ(kind_of_file("0\n1\n2\n"), "");
  EXPECT_EQ(kind_of_file("value of something\n"), "");
}

TEST(FileKind, FolderIsRefusedAsOne) {
  try {
    read_garmentcode(LOOSEFIT_SOURCE_DIR);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("found a folder, expected GarmentCode JSON"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace loosefit::io
