#include "loosefit/io/mesh_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/io/mesh_obj.h"
#include "support/mesh_bytes.h"

namespace loosefit::io {
namespace {

class MeshFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("loosefit_mesh_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

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
  std::filesystem::path folder_;
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
  EXPECT_NE(refusal("g.obj", "").find("0 vertices"), std::string::npos);
  EXPECT_NE(refusal("h.xyz", three).find(".xyz"), std::string::npos);
  EXPECT_THROW(read_mesh(path("missing.obj")), IoError);
  EXPECT_THROW(read_mesh(folder_.string()), IoError);
}

TEST_F(MeshFileTest, BrokenPlyHeadersAndBodies) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  refusal("a.ply", "ply\n");
  refusal("b.ply", "ply\nformat binary_big_endian 1.0\nend_header\n");
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
