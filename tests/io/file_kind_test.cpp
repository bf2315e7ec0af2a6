#include "loosefit/io/file_kind.h"

#include <gtest/gtest.h>

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
