#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/io/vtp_read.h"
#include "loosefit/io/vtp_seal.h"
#include "loosefit/io/vtp_write.h"
#include "support/scratch_folder.h"
#include "support/tube_garment.h"

namespace loosefit::io {
namespace {

class Vtp : public ::testing::Test {
 protected:
  void SetUp() override {
    garment_ = testing::tube_garment(0.7, 0.3, 24, 6);
    drape_ = testing::settled_drape(garment_, [](const Vec2& uv) {
      return Vec3(std::cos(9 * uv.x()) / 9, std::sin(9 * uv.x()) / 9, 1 + uv.y() / 3);
    });
    drape_.certificate = {2.5e-4, 1.0 / 3, 0, 7, "time budget"};
    map_.array = "distance_mm";
    for (int i = 0; i < garment_.vertex_count; ++i) map_.values.push_back(i / 7.0);
    map_.values[3] = std::nan("");
  }
  static std::string bytes(const std::filesystem::path& p) {
    std::ifstream f(p, std::ios::binary);
    return {std::istreambuf_iterator<char>(f), {}};
  }
  const support::ScratchFolder dir_;
  garment::Garment garment_;
  drape::Drape drape_;
  maps::PerformanceMap map_;
};

TEST_F(Vtp, DrapeComesBackToTheLastBit) {
  write_drape_vtp(dir_ / "d.vtp", garment_, drape_, {map_},
                  {{"velocity", 3, std::vector<double>(3 * garment_.vertex_count, 0.1)}});
  const DrapeFile file = read_drape_vtp(dir_ / "d.vtp");
  EXPECT_EQ(file.drape.positions, drape_.positions);
  EXPECT_EQ(file.garment.triangles, garment_.triangles);
  EXPECT_EQ(file.garment.triangle_uv, garment_.triangle_uv);
  EXPECT_EQ(file.garment.vertex_uv, garment_.vertex_uv);
  EXPECT_EQ(file.garment.triangle_panel, garment_.triangle_panel);
  EXPECT_EQ(file.garment.panel_names, garment_.panel_names);
  EXPECT_NEAR(file.garment.area, 0.21, 1e-12);
  EXPECT_EQ(file.drape.certificate.residual, 2.5e-4);
  EXPECT_EQ(file.drape.certificate.residual_max, 1.0 / 3);
  EXPECT_EQ(file.drape.certificate.intersections_self, 7);
  EXPECT_EQ(file.drape.certificate.stop_reason, "time budget");
  ASSERT_NE(file.find("distance_mm"), nullptr);
  EXPECT_EQ(file.find("distance_mm")->values[5], 5 / 7.0);
  EXPECT_TRUE(std::isnan(file.find("distance_mm")->values[3]));
  ASSERT_NE(file.find("velocity"), nullptr);
  EXPECT_EQ(file.find("velocity")->components, 3);
  EXPECT_TRUE(file.drape.body_normal_force.empty());
}

TEST_F(Vtp, StabilityAndFoldedEdgesComeBackAndMayBeUnknown) {
  write_drape_vtp(dir_ / "d.vtp", garment_, drape_);
  EXPECT_FALSE(read_drape_vtp(dir_ / "d.vtp").drape.certificate.stable.has_value());
  EXPECT_EQ(read_drape_vtp(dir_ / "d.vtp").drape.certificate.allowed_residual,
            solver::kRestTolerance);
  drape_.certificate.allowed_residual = 0.03;
  write_drape_vtp(dir_ / "d.vtp", garment_, drape_);
  EXPECT_EQ(read_drape_vtp(dir_ / "d.vtp").drape.certificate.allowed_residual, 0.03);
  drape_.certificate.folded_edges = 3;
  for (const bool stable : {true, false}) {
    drape_.certificate.stable = stable;
    write_drape_vtp(dir_ / "d.vtp", garment_, drape_);
    EXPECT_EQ(read_drape_vtp(dir_ / "d.vtp").drape.certificate.stable, stable);
    EXPECT_EQ(read_drape_vtp(dir_ / "d.vtp").drape.certificate.folded_edges, 3);
  }
}

TEST_F(Vtp, NormalForceOfTheBodyComesBackWithTheDrape) {
  for (int i = 0; i < garment_.vertex_count; ++i) drape_.body_normal_force.push_back(i / 3.0);
  write_drape_vtp(dir_ / "d.vtp", garment_, drape_);
  const DrapeFile file = read_drape_vtp(dir_ / "d.vtp");
  EXPECT_EQ(file.drape.body_normal_force, drape_.body_normal_force);
  EXPECT_EQ(file.find("body_normal_force_N"), nullptr);  // it is a field of the drape
  drape_.body_normal_force.pop_back();
  EXPECT_THROW(write_drape_vtp(dir_ / "d.vtp", garment_, drape_), InvalidInput);
}

TEST_F(Vtp, EqualInputGivesEqualBytes) {
  write_drape_vtp(dir_ / "a.vtp", garment_, drape_, {map_});
  write_drape_vtp(dir_ / "b.vtp", garment_, drape_, {map_});
  const std::string a = bytes(dir_ / "a.vtp");
  EXPECT_FALSE(a.empty());
  EXPECT_EQ(a, bytes(dir_ / "b.vtp"));
  EXPECT_NE(a.find("AppendedData encoding=\"raw\""), std::string::npos);
  EXPECT_NE(a.find("vtkZLibDataCompressor"), std::string::npos);
}

TEST_F(Vtp, BodyIsWrittenWithSegmentsAndItsSurfaceComesBackToTheLastBit) {
  const body::Body body = testing::cylinder_body(0.1, 1, 12, 3);
  write_body_vtp(dir_ / "body.vtp", body);
  const geometry::TriangleMesh read = read_body_vtp(dir_ / "body.vtp");
  EXPECT_EQ(read.vertices, body.surface.vertices);
  EXPECT_EQ(read.triangles, body.surface.triangles);
  EXPECT_NE(bytes(dir_ / "body.vtp").find("Name=\"segment\""), std::string::npos);
}

TEST_F(Vtp, WrongLengthsAreNamed) {
  map_.values.pop_back();
  EXPECT_THROW(write_drape_vtp(dir_ / "d.vtp", garment_, drape_, {map_}), InvalidInput);
  drape_.positions.pop_back();
  EXPECT_THROW(write_drape_vtp(dir_ / "d.vtp", garment_, drape_), InvalidInput);
}

TEST_F(Vtp, UnwritablePlaceIsAnIoError) {
  EXPECT_THROW(write_drape_vtp(dir_ / "no" / "d.vtp", garment_, drape_), IoError);
  EXPECT_THROW(write_drape_vtp("/dev/full", garment_, drape_), IoError);
}

TEST_F(Vtp, BrokenFilesGiveOneErrorEach) {
  EXPECT_THROW(read_drape_vtp(dir_ / "missing.vtp"), IoError);
  std::ofstream(dir_ / "text.vtp") << "hello";
  EXPECT_THROW(read_drape_vtp(dir_ / "text.vtp"), InvalidInput);
  std::ofstream(dir_ / "xml.vtp") << "<a><b></a>";
  EXPECT_THROW(read_drape_vtp(dir_ / "xml.vtp"), InvalidInput);
  write_body_vtp(dir_ / "body.vtp", testing::cylinder_body(0.1, 1, 12, 3));
  EXPECT_THROW(read_drape_vtp(dir_ / "body.vtp"), InvalidInput);
  write_drape_vtp(dir_ / "d.vtp", garment_, drape_, {map_});
  const std::string whole = bytes(dir_ / "d.vtp");
  for (std::size_t keep = 100; keep < whole.size(); keep += 517) {
    std::ofstream(dir_ / "cut.vtp", std::ios::binary) << whole.substr(0, keep);
    EXPECT_THROW(read_drape_vtp(dir_ / "cut.vtp"), Error) << keep;
  }
}

TEST_F(Vtp, AnyDamagedByteIsRefused) {
  write_drape_vtp(dir_ / "d.vtp", garment_, drape_, {map_});
  const std::string whole = bytes(dir_ / "d.vtp");
  for (std::size_t place = 0; place < whole.size() - 1; place += 7) {
    std::string bad = whole;
    bad[place] = static_cast<char>(bad[place] + 1);
    std::ofstream(dir_ / "bad.vtp", std::ios::binary) << bad;
    EXPECT_THROW(read_drape_vtp(dir_ / "bad.vtp"), InvalidInput) << place;
  }
}

TEST_F(Vtp, SealedFileThatIsNoDrapeIsRefused) {
  for (const std::string content : {"hello", "<a><b></a>", "<?xml version=\"1.0\"?><VTKFile/>"}) {
    std::ofstream(dir_ / "odd.vtp", std::ios::binary) << content << vtp_seal(content);
    EXPECT_THROW(read_drape_vtp(dir_ / "odd.vtp"), InvalidInput) << content;
  }
}

}  // namespace
}  // namespace loosefit::io
