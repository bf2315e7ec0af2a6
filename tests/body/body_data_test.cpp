#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/body/catmull_clark.h"
#include "loosefit/body/raw_body_data.h"
#include "support/body_fixture.h"
#include "support/scratch_folder.h"

namespace loosefit::body {
namespace {

// The source files, fetched by tools/setup_body_data.sh; without them these tests fail.
const RawBodyData& raw() {
  static const RawBodyData data = read_raw_body_data(LOOSEFIT_SOURCE_DIR "/var/body/raw");
  return data;
}

struct BlockSum {
  int index;
  const char* name;
  int nonzero, nonzero_body;
  long sum, sum_abs;
};

TEST(RawBodyData, BlockSumsOfTheReference) {
  const BlockSum kSums[] = {
      {743, "macrodetails/african-male-child", 19158, 13380, -34202419, 40696497},
      {757, "macrodetails/caucasian-female-young", 19150, 13380, -8761798, 14029234},
      {780, "macrodetails/height/female-child-averagemuscle-averageweight-maxheight", 19150, 13380,
       74358597, 85632969},
      {1089, "measure/measure-bust-increase", 1850, 1169, -107396, 402756},
      {1120, "measure/measure-waist-decrease", 1423, 818, 12877, 174317},
      {1239, "stomach/stomach-tone-incr", 437, 199, 14223, 83213}};
  ASSERT_EQ(raw().target_names.size(), 1258u);
  for (const auto& expected : kSums) {
    SCOPED_TRACE(expected.name);
    EXPECT_EQ(raw().target_names[std::size_t(expected.index)], expected.name);
    const TargetBlock block = read_target_block(raw(), expected.index);
    int nonzero = 0, nonzero_body = 0;
    long sum = 0, sum_abs = 0;
    for (std::size_t v = 0; v < block.size(); ++v) {
      const bool moves = block[v] != std::array<std::int16_t, 3>{};
      nonzero += moves;
      nonzero_body += moves && v < 13380;
      for (const auto value : block[v]) sum += value, sum_abs += std::abs(long(value));
    }
    EXPECT_EQ(nonzero, expected.nonzero);
    EXPECT_EQ(nonzero_body, expected.nonzero_body);
    EXPECT_EQ(sum, expected.sum);
    EXPECT_EQ(sum_abs, expected.sum_abs);
  }
  long third = 0;
  for (const auto& shift : read_target_block(raw(), 3))
    third += long(shift[0]) + shift[1] + shift[2];
  EXPECT_EQ(third, 2952);
}

TEST(RawBodyData, MirrorMapIsABijection) {
  std::set<int> images(raw().mirror.begin(), raw().mirror.end());
  EXPECT_EQ(images.size(), 19158u);
  int own = 0;
  for (int v = 0; v < 13380; ++v) own += raw().mirror[std::size_t(v)] == v;
  EXPECT_EQ(own, 188);
}

TEST(RawBodyData, RepairMakesALopsidedTargetSymmetric) {
  const auto& names = raw().target_names;
  const std::string name = "measure/measure-bust-decrease";
  const int index = int(std::find(names.begin(), names.end(), name) - names.begin());
  TargetBlock block = read_target_block(raw(), index);
  const auto worst = [&] {
    int most = 0;
    for (std::size_t v = 0; v < block.size(); ++v) {
      const auto& other = block[std::size_t(raw().mirror[v])];
      most = std::max({most, std::abs(block[v][0] + other[0]), std::abs(block[v][1] - other[1]),
                       std::abs(block[v][2] - other[2])});
    }
    return most;
  };
  EXPECT_GT(worst(), 200);  // 20 mm at full weight
  repair_target(raw(), name, block);
  EXPECT_EQ(worst(), 0);
}

TEST(RawBodyData, BakingAgainGivesTheSameFile) {
  const support::ScratchFolder scratch;
  const auto path = scratch / "baked.lfb";
  write_body_data(path.string(), bake_body_data(LOOSEFIT_SOURCE_DIR "/var/body/raw"));
  const auto bytes = [](const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), {});
  };
  EXPECT_TRUE(bytes(path) == bytes(default_body_data_path()));
}

TEST(BodyData, SkinIsClosedManifoldAndOutward) {
  const BodyData& data = body_model().data();
  EXPECT_EQ(data.body_vertices, 13380);
  EXPECT_EQ(data.quads.size(), 13378u);
  std::set<std::pair<int, int>> directed;
  for (const auto& q : data.quads) {
    for (std::size_t c = 0; c < 4; ++c) EXPECT_TRUE(directed.emplace(q[c], q[(c + 1) % 4]).second);
  }
  EXPECT_EQ(directed.size(), 2u * 26756u);
  for (const auto& [a, b] : directed) ASSERT_TRUE(directed.contains({b, a}));
  EXPECT_EQ(13380 - 26756 + 13378, 2);
  geometry::TriangleMesh base;
  base.vertices.assign(data.base.begin(), data.base.begin() + 13380);
  base.triangles = triangulate(data.quads);
  EXPECT_NEAR(geometry::enclosed_volume(base) * 1000, 54.895, 0.001);
  EXPECT_EQ(data.quads.front(), (std::array<int, 4>{4848, 0, 1, 4847}));
  EXPECT_EQ(data.quads.back(), (std::array<int, 4>{7267, 520, 537, 7282}));
}

TEST(BodyData, EveryRepairedFieldIsMirrorSymmetric) {
  const BodyData& data = body_model().data();
  const std::set<std::string> one_sided = {
      "torso/torso-trans-horiz-in", "torso/torso-trans-horiz-out", "hip/hip-trans-in",
      "hip/hip-trans-out",          "neck/neck-trans-horiz-in",    "neck/neck-trans-horiz-out"};
  EXPECT_EQ(data.field_of_name.size(), 770u);
  EXPECT_EQ(data.fields.size(), 493u);
  int checked = 0;
  for (const auto& [name, index] : data.field_of_name) {
    if (index < 0 || name.starts_with("armslegs/") || one_sided.contains(name)) continue;
    const BodyField& field = data.fields[std::size_t(index)];
    std::map<int, std::array<std::int16_t, 3>> at;
    for (std::size_t i = 0; i < field.rows.size(); ++i) at[field.rows[i]] = field.shift[i];
    for (const auto& [row, shift] : at) {
      const std::array<std::int16_t, 3> image = {std::int16_t(-shift[0]), shift[1], shift[2]};
      const auto other = at.find(data.mirror[std::size_t(row)]);
      ASSERT_TRUE(other != at.end() && other->second == image) << name << " row " << row;
    }
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

TEST(BodyData, SkinWeightsAreSymmetricAndSumToOne) {
  const BodyData& data = body_model().data();
  const auto mirrored = [&](int bone) {
    std::string name = data.bones[std::size_t(bone)].name;
    if (name.ends_with(".L"))
      name.back() = 'R';
    else if (name.ends_with(".R"))
      name.back() = 'L';
    return data.bone(name);
  };
  std::vector<int> other(data.bones.size());
  for (std::size_t b = 0; b < other.size(); ++b) other[b] = mirrored(int(b));
  for (int v = 0; v < data.body_vertices; ++v) {
    std::map<int, double> here, there;
    double sum = 0;
    for (const auto& [bone, weight] : data.skin[std::size_t(v)]) here[bone] = weight, sum += weight;
    for (const auto& [bone, weight] : data.skin[std::size_t(data.mirror[std::size_t(v)])]) {
      there[other[std::size_t(bone)]] = weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    ASSERT_EQ(here.size(), there.size()) << v;
    for (const auto& [bone, weight] : here) ASSERT_NEAR(there[bone], weight, 1e-12) << v;
  }
}

TEST(BodyData, MissingAndDamagedFilesAreNamed) {
  EXPECT_THROW(read_body_data("/nonexistent/body.lfb"), IoError);
  const support::ScratchFolder folder;
  std::ifstream in(default_body_data_path(), std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), {});
  const auto path = (folder / "damaged.lfb").string();
  const auto refuse = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    try {
      read_body_data(path);
      ADD_FAILURE() << "a damaged file was accepted";
    } catch (const IoError& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
      EXPECT_NE(error.hint().find("loosefit setup"), std::string::npos);
    }
  };
  refuse("");
  refuse("solid something else entirely");
  refuse(good.substr(0, good.size() / 2));
  std::string flipped = good;
  flipped[good.size() / 2] = char(flipped[good.size() / 2] ^ 0x10);
  refuse(flipped);
  std::string version = good;
  version[7] = '9';
  refuse(version);
}

}  // namespace
}  // namespace loosefit::body
