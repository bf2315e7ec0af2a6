#include "loosefit/io/glb_write.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

struct Glb {
  std::uint32_t version = 0, length = 0;
  nlohmann::json json;
  std::string binary, bytes;

  explicit Glb(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
    const auto number = [&](std::size_t at) {
      std::uint32_t n = 0;
      std::memcpy(&n, bytes.data() + at, 4);
      return n;
    };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    version = number(4);
    length = number(8);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::uint32_t text = number(12);
    json = nlohmann::json::parse(bytes.substr(20, text));
    EXPECT_EQ(bytes.substr(24 + text, 4), std::string("BIN\0", 4));
    binary = bytes.substr(28 + text, number(20 + text));
    EXPECT_EQ(text % 4, 0u);
    EXPECT_EQ(binary.size() % 4, 0u);
  }

  template <class Number>
  std::vector<Number> read(int accessor, int size) const {
    const auto& a = json["accessors"][accessor];
    const auto& view = json["bufferViews"][a["bufferView"].get<int>()];
    std::vector<Number> numbers(a["count"].get<std::size_t>() * size);
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), numbers.size() * sizeof(Number));
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + numbers.size() * sizeof(Number),
              binary.size());
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    std::memcpy(numbers.data(), binary.data() + view["byteOffset"].get<std::size_t>(),
                numbers.size() * sizeof(Number));
    return numbers;
  }
};

class GlbFile : public ::testing::Test {
 protected:
  const support::ScratchFolder scratch_;
  const std::filesystem::path path_ = scratch_ / "surface.glb";
  GlbSurface surface_{.name = "cloth \"a\"",
                      .positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 2}, {0, -0.5, 2}},
                      .triangles = {{0, 1, 2}, {0, 2, 3}},
                      .colours = {{255, 255, 255}, {0, 0, 0}, {255, 0, 128}, {10, 20, 30}}};
};

TEST_F(GlbFile, HoldsTheSurfaceWithYUp) {
  write_glb(path_, {surface_}, {{{"map", "Body-garment distance"}}});
  const Glb file(path_);
  EXPECT_EQ(file.version, 2u);
  EXPECT_EQ(file.length, file.bytes.size());
  EXPECT_EQ(file.json["asset"]["version"], "2.0");
  EXPECT_EQ(file.json["asset"]["extras"]["map"], "Body-garment distance");
  EXPECT_EQ(file.json["nodes"][0]["name"], surface_.name);
  EXPECT_EQ(file.json["buffers"][0]["byteLength"], file.binary.size());
  const auto& primitive = file.json["meshes"][0]["primitives"][0];
  const std::vector<float> at = file.read<float>(primitive["attributes"]["POSITION"], 3);
  EXPECT_EQ(at, (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0.5}));
  const auto& bounds = file.json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
  EXPECT_EQ(bounds["min"], (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(bounds["max"], (std::vector<float>{1, 2, 0.5}));
  EXPECT_EQ(file.read<std::uint32_t>(primitive["indices"], 1),
            (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  const std::vector<float> n = file.read<float>(primitive["attributes"]["NORMAL"], 3);
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_NEAR(std::hypot(n[3 * v], n[3 * v + 1], n[3 * v + 2]), 1, 1e-6);
  EXPECT_GT(n[5], 0.9) << "the wearer's front, -y, is +z of the file";
}

TEST_F(GlbFile, ColoursAreInLinearLight) {
  GlbSurface plain = surface_;
  plain.colours.clear();
  plain.colour = {128, 255, 0};
  write_glb(path_, {surface_, plain});
  const Glb file(path_);
  const auto& primitive = file.json["meshes"][0]["primitives"][0];
  const auto& colour = file.json["accessors"][primitive["attributes"]["COLOR_0"].get<int>()];
  EXPECT_EQ(colour["type"], "VEC4");
  EXPECT_EQ(colour["componentType"], 5123);
  EXPECT_TRUE(colour["normalized"].get<bool>());
  const std::vector<std::uint16_t> c =
      file.read<std::uint16_t>(primitive["attributes"]["COLOR_0"], 4);
  EXPECT_EQ(std::vector<std::uint16_t>(c.begin(), c.begin() + 8),
            (std::vector<std::uint16_t>{65535, 65535, 65535, 65535, 0, 0, 0, 65535}));
  EXPECT_NEAR(c[10] / 65535.0, 0.21586, 1e-4) << "128 of 255 is 21.6 % of the light";
  const auto& other = file.json["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(other[0].get<double>(), 0.21586, 1e-4);
  EXPECT_FALSE(file.json["meshes"][1]["primitives"][0]["attributes"].contains("COLOR_0"));
}

TEST_F(GlbFile, WrongSurfacesAndPlacesAreErrors) {
  GlbSurface bad = surface_;
  bad.colours.pop_back();
  EXPECT_THROW(write_glb(path_, {bad}), InvalidInput);
  bad = surface_;
  bad.triangles[1][2] = 4;
  EXPECT_THROW(write_glb(path_, {bad}), InvalidInput);
  bad.triangles.clear();
  EXPECT_THROW(write_glb(path_, {bad}), InvalidInput);
  EXPECT_THROW(write_glb(path_ / "no such folder" / "x.glb", {surface_}), IoError);
}

}  // namespace
}  // namespace loosefit::io
