#include "loosefit/io/mesh_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/io/mesh_obj.h"
#include "support/mesh_bytes.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

class MeshFileTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  /// The message of the error that reading raises; fails when there is none.
  std::string refusal(const std::string& name, const std::string& bytes) const {
    const std::string file = put(name, bytes);
    try {
      read_mesh(file);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
      return error.what();
    }
    ADD_FAILURE() << name << " was accepted: " << bytes.substr(0, 60);
    return "";
  }
  const support::ScratchFolder folder_;
};

geometry::TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

void expect_same(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  EXPECT_NEAR(geometry::enclosed_volume(a), geometry::enclosed_volume(b), 1e-7);
}

TEST_F(MeshFileTest, ObjReadsBackAndBinaryPlyAndStlAreRead) {
  const geometry::TriangleMesh mesh = tetrahedron();
  write_obj(path("a.obj"), mesh);
  write_obj(path("n.obj"), mesh, geometry::vertex_normals(mesh.vertices, mesh.triangles));
  put("a.ply", support::ply_bytes(mesh));
  put("a.stl", support::stl_bytes(mesh));
  for (const char* name : {"a.obj", "n.obj", "a.ply", "a.stl"}) {
    SCOPED_TRACE(name);
    expect_same(read_mesh(path(name)).mesh, mesh);
  }
}

TEST_F(MeshFileTest, ObjFormsAndPolygons) {
  const auto file =
      read_mesh(put("b.obj",
                    "# comment\r\nmtllib x.mtl\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 0\n"
                    "vt 0 0\nvn 0 0 1\ng g\nf 1/1 2/1/1 3//1 -1\n"));
  EXPECT_EQ(file.mesh.vertices.size(), 4u);
  ASSERT_EQ(file.mesh.triangles.size(), 2u);
  EXPECT_EQ(file.mesh.triangles[1], (Triangle{0, 2, 3}));
}

TEST_F(MeshFileTest, AsciiPlyAndStl) {
  const auto ply = read_mesh(
      put("c.ply",
          "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\n"
          "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n0 0 0 255\n1 0 0 255\n0 1 0 255\n"
          "3 0 1 2\n"));
  EXPECT_EQ(ply.mesh.vertices[1], Vec3(1, 0, 0));
  EXPECT_EQ(ply.mesh.triangles.size(), 1u);
  const auto stl = read_mesh(
      put("c.stl",
          "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
          "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
          "vertex 0 1 0\nendloop\nendfacet\nendsolid x\n"));
  EXPECT_EQ(stl.mesh.vertices.size(), 4u);  // two shared corners welded
  EXPECT_EQ(stl.mesh.triangles.size(), 2u);
}

TEST_F(MeshFileTest, RepeatedCornersAreDroppedWithAWarning) {
  const auto file = read_mesh(put("d.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n"));
  EXPECT_EQ(file.mesh.triangles.size(), 1u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("1 triangles"), std::string::npos);
}

TEST_F(MeshFileTest, ErrorsNameTheLineAndTheWord) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_NE(refusal("a.obj", three + "f 1 2 4\n").find(":4: found vertex 4"), std::string::npos);
  EXPECT_NE(refusal("b.obj", "v 0 0 zero\n").find(":1: found \"zero\""), std::string::npos);
  EXPECT_NE(refusal("c.obj", "v 0 0\n").find("2 coordinates"), std::string::npos);
  EXPECT_NE(refusal("d.obj", three + "f 1 2\n").find("2 corners"), std::string::npos);
  EXPECT_NE(refusal("e.obj", three + "f 0 1 2\n").find("vertex 0"), std::string::npos);
  EXPECT_NE(refusal("f.obj", "v nan 0 0\n").find("nan"), std::string::npos);
  EXPECT_NE(refusal("g.obj", "").find("an empty file"), std::string::npos);
  EXPECT_NE(refusal("h.xyz", "0 0 0\n1 0 0\n").find("cloud of points"), std::string::npos);
  EXPECT_NE(refusal("i.obj", three).find("3 vertices and 0 faces"), std::string::npos);
  EXPECT_THROW(read_mesh(path("missing.obj")), IoError);
  EXPECT_THROW(read_mesh(folder_.string()), IoError);
}

TEST_F(MeshFileTest, FilesThatAreCutOffAnywhereSaySo) {
  const std::vector<std::array<float, 3>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<int, 3>> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto head = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  };
  std::string text, bytes, stl = "solid x\n";
  for (const auto& c : corners) {
    text += fmt::format("{} {} {}\n", c[0], c[1], c[2]);
    bytes.append(reinterpret_cast<const char*>(c.data()), 12);
  }
  for (const auto& f : faces) {
    text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
    bytes += '\3';
    bytes.append(reinterpret_cast<const char*>(f.data()), 12);
    stl += "facet normal 0 0 1\nouter loop\n";
    for (const int k : f)
      stl += fmt::format("vertex {} {} {}\n", corners[k][0], corners[k][1], corners[k][2]);
    stl += "endloop\nendfacet\n";
  }
  const auto hint = [&](const std::string& name, const std::string& content) -> std::string {
    try {
      read_mesh(put(name, content));
      return "read";
    } catch (const Error& error) {
      return error.hint();
    }
  };
  const std::string ascii = head("ascii"), binary = head("binary_little_endian");
  for (std::size_t n = 5; n < ascii.size() - 1; ++n)
    EXPECT_NE(hint("h.ply", ascii.substr(0, n)).find("cut off"), std::string::npos) << n;
  for (std::size_t n = 1; n + 2 < text.size(); ++n)
    EXPECT_NE(hint("a.ply", ascii + text.substr(0, n)).find("cut off"), std::string::npos) << n;
  for (std::size_t n = 1; n < bytes.size(); ++n)
    EXPECT_NE(hint("b.ply", binary + bytes.substr(0, n)).find("cut off"), std::string::npos) << n;
  for (std::size_t n = 30; n < stl.size(); ++n)
    EXPECT_NE(hint("c.stl", stl.substr(0, n)).find("cut off"), std::string::npos)
        << stl.substr(0, n);
  EXPECT_NE(refusal("n.ply", binary + bytes.substr(0, 20)).find("in vertex 2 of 4"),
            std::string::npos);
  // Head and body of different formats.
  EXPECT_NE(refusal("x.ply", binary + text).find("numbers as text behind end_header"),
            std::string::npos);
  EXPECT_NE(refusal("y.ply", ascii + bytes).find("binary data behind end_header"),
            std::string::npos);
  EXPECT_NE(hint("z.ply", head("binary_big_endian") + bytes).find("format line"),
            std::string::npos);
}

TEST_F(MeshFileTest, WhatHoldsNoSurfaceIsNamedWithAWayToOne) {
  for (const auto& [content, kind] :
       {std::pair<std::string, std::string>{"\x89PNG\r\n\x1a\n", "a picture (PNG)"},
        {"G21\nG0 X1 Y2\nG1 X3\n", "a machine program (G-code)"},
        {"PK\x03\x04....word/document.xml", "a Word document (docx)"},
        {"OFF 1 1 1\n", "a mesh (OFF)"},
        {std::string("Kaydara FBX Binary  \0", 21), "a mesh (FBX)"},
        {"what is this\n", "begins with \"what is this\""},
        {"1 2 3\n4,5 6 7\n", "a cloud of points"}})
    try {
      read_mesh(put("x.dat", content));
      FAIL() << kind;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(kind), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("a surface (OBJ, PLY or STL)"), std::string::npos);
      EXPECT_TRUE(error.hint().find("OBJ") != std::string::npos ||
                  error.hint().find("faces") != std::string::npos)
          << error.hint();
      EXPECT_EQ(error.hint().find("SVG"), std::string::npos) << "of use to patterns alone";
    }
}

TEST_F(MeshFileTest, BrokenPlyHeadersAndBodies) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  refusal("a.ply", "ply\n");
  refusal("b.ply", "ply\nformat binary_middle_endian 1.0\nend_header\n");
  refusal("c.ply", "ply\nformat ascii 1.0\nelement vertex -3\nend_header\n");
  refusal("d.ply", head + "0 0 0\n1 0 0\n");
  EXPECT_NE(refusal("e.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n").find("vertex 9"),
            std::string::npos);
  refusal("f.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n");
  refusal("g.ply", head + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n");
  refusal("h.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty complex x\nend_header\n0\n");
}

TEST_F(MeshFileTest, BrokenStl) {
  refusal("a.stl", "not an stl\n");
  refusal("b.stl", "solid x\nvertex 0 0\nendsolid\n");
  refusal("c.stl", std::string(84, '\0'));
  const std::string good = support::stl_bytes(tetrahedron());
  refusal("d.stl", good.substr(0, good.size() - 10));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string in_utf16(const std::string& ascii) {
  std::string bytes = "\xff\xfe";
  for (const char c : ascii) bytes += {c, '\0'};
  return bytes;
}

/// A sphere of n rings of m faces.
geometry::TriangleMesh sphere(int n, int m) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = kPi * i / n, b = 2 * kPi * j / m;
      mesh.vertices.emplace_back(0.3 * std::sin(a) * std::cos(b), 0.3 * std::sin(a) * std::sin(b),
                                 0.85 - 0.85 * std::cos(a));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const int k = (j + 1) % m;
      mesh.triangles.push_back({i * m + j, (i + 1) * m + j, (i + 1) * m + k});
      mesh.triangles.push_back({i * m + j, (i + 1) * m + k, i * m + k});
    }
  return mesh;
}

TEST_F(MeshFileTest, OneSurfaceIsTheSameInEveryDialectOfObj) {
  const geometry::TriangleMesh mesh = sphere(6, 9);
  write_obj(path("plain.obj"), mesh);
  std::ifstream in(path("plain.obj"), std::ios::binary);
  const std::string plain((std::istreambuf_iterator<char>(in)), {});
  const std::string comma = replaced(plain, ".", ",");
  for (const std::string& text :
       {plain, replaced(plain, "\n", "\r\n"), replaced(plain, "\n", "\r"), comma,
        replaced(comma, "\n", "\r"), "\xEF\xBB\xBF" + plain, in_utf16(plain),
        in_utf16(replaced(plain, "\n", "\r\n")), plain.substr(plain.find('\n') + 1)}) {
    SCOPED_TRACE(text.substr(0, 80));
    expect_same(read_mesh(put("d.obj", text)).mesh, mesh);
  }
}

TEST_F(MeshFileTest, StripsOfTrianglesAreTheFacesTheyStandFor) {
  // A fan of two rows of points, as one strip and as several ended by −1.
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
  const geometry::TriangleMesh one = read_mesh(put("s.ply", head + "6 0 1 2 3 4 5\n")).mesh;
  ASSERT_EQ(one.triangles.size(), 4u);
  for (const Triangle& t : one.triangles) {
    const Vec3 a = one.vertices[t[0]], b = one.vertices[t[1]], c = one.vertices[t[2]];
    EXPECT_LT((b - a).cross(c - a).z(), 0) << "all look the same way";
  }
  EXPECT_EQ(read_mesh(put("s.ply", head + "9 0 1 2 3 -1 2 3 4 5\n")).mesh.triangles.size(), 4u);
  EXPECT_EQ(read_mesh(put("s.ply", head + "8 0 1 2 3 3 4 4 5\n")).mesh.triangles.size(), 2u)
      << "joined by triangles without area";
  EXPECT_NE(refusal("s.ply", head + "3 0 1 9\n").find("vertex 9"), std::string::npos);
}

TEST_F(MeshFileTest, BinaryPlyIsReadInBothByteOrders) {
  const std::string little = support::ply_bytes(tetrahedron());
  const std::size_t body = little.find("end_header\n") + 11;
  // Numbers of that file: coordinates of 8 bytes; a face is one byte and three of 4.
  std::string big = little.substr(0, body);
  big.replace(big.find("little"), 6, "big");
  const auto turn = [&](std::size_t at, std::size_t size) {
    for (std::size_t k = size; k-- > 0;) big += little[at + k];
  };
  std::size_t at = body;
  for (int k = 0; k < 12; ++k, at += 8) turn(at, 8);
  for (int f = 0; f < 4; ++f) {
    turn(at++, 1);
    for (int k = 0; k < 3; ++k, at += 4) turn(at, 4);
  }
  ASSERT_EQ(at, little.size());
  expect_same(read_mesh(put("b.ply", big)).mesh, tetrahedron());
}

TEST_F(MeshFileTest, AnStlThatIsCutAnywhereSaysSo) {
  const geometry::TriangleMesh mesh = sphere(3, 4);
  std::string binary = support::stl_bytes(mesh);
  const std::size_t count = mesh.triangles.size();
  std::string titled = binary;
  titled.replace(0, 10, "solid body");
  for (const std::string& whole : {binary, titled})
    for (std::size_t size = 1; size < whole.size(); size += size < 90 ? 1 : 7) {
      const std::string message = refusal("cut.stl", whole.substr(0, size));
      const std::string words =
          size >= 84 ? fmt::format("{} triangles announced, bytes for {}", count, (size - 84) / 50)
                     : std::string("found ");
      EXPECT_NE(message.find(words), std::string::npos) << size << ": " << message;
    }
  EXPECT_NE(refusal("long.stl", binary + "more")
                .find(fmt::format("{0} triangles announced, bytes for {0}", count)),
            std::string::npos);
  // As text, at every length before the word that ends it.
  std::string text = "solid a\n";
  for (const Triangle& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : t)
      text += fmt::format("vertex {} {} {}\n", mesh.vertices[v].x(), mesh.vertices[v].y(),
                          mesh.vertices[v].z());
    text += "endloop\nendfacet\n";
  }
  EXPECT_GT(read_mesh(put("text.stl", text + "endsolid a\n")).mesh.triangles.size(), 0u);
  for (std::size_t size = 1; size < text.size(); size += 3)
    refusal("cut.stl", text.substr(0, size));
  EXPECT_NE(refusal("cut.stl", text).find("expected endsolid"), std::string::npos);
}

TEST_F(MeshFileTest, FilesOfOtherProgramsAreNamed) {
  for (const auto& [bytes, kind] :
       {std::pair<std::string, std::string>{"HIERARCHY\nROOT hip\n", "a motion (BVH)"},
        {std::string("glTF\2\0\0\0", 8), "a mesh (glTF)"},
        {"Kaydara FBX Binary  ", "a mesh (FBX)"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer"},
        {"<!DOCTYPE html><html>", "a web page"},
        {"BLENDER-v300", "a Blender file"},
        {"OFF\n3 1 0\n", "a mesh (OFF)"}})
    for (const char* name : {"x.obj", "x.ply", "x.stl"})
      EXPECT_NE(refusal(name, bytes).find("found " + kind), std::string::npos) << kind;
}

TEST_F(MeshFileTest, AUnitInACommentIsTold) {
  const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const auto& [comment, unit] :
       {std::pair<std::string, std::string>{"# File units = inches\n", "in"},
        {"# Units: Centimeters\n", "cm"},
        {"# exported, unit mm\n", "mm"},
        {"# metres, z up, facing -y\n", "m"},
        {"# units unknown\n", ""},
        {"# made in one unit\n", ""},
        {"", ""}})
    EXPECT_EQ(read_mesh(put("u.obj", comment + faces)).units, unit) << comment;
}

// Whatever a file holds, reading ends in a surface or in one of our errors.
TEST_F(MeshFileTest, MutatedFilesNeverCrash) {
  write_obj(path("seed.obj"), tetrahedron());
  put("seed.ply", support::ply_bytes(tetrahedron()));
  put("seed.stl", support::stl_bytes(tetrahedron()));
  std::uint64_t state = 88172645463325252ull;
  const auto random = [&](std::uint64_t n) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state % n;
  };
  int refused = 0;
  for (const char* extension : {".obj", ".ply", ".stl"}) {
    std::ifstream in(path(std::string("seed") + extension), std::ios::binary);
    const std::string seed((std::istreambuf_iterator<char>(in)), {});
    for (int round = 0; round < 300; ++round) {
      std::string bytes = seed;
      for (std::uint64_t n = 1 + random(4); n > 0; --n)
        bytes[random(bytes.size())] = char(random(256));
      if (random(3) == 0) bytes.resize(random(bytes.size()));
      try {
        const MeshFile file = read_mesh(put(std::string("m") + extension, bytes));
        for (const auto& t : file.mesh.triangles) {
          for (const int corner : t) ASSERT_LT(std::size_t(corner), file.mesh.vertices.size());
        }
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace loosefit::io
