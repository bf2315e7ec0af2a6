// What programs of others find in our files, read by VTK's own readers.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <fstream>
#include <random>
#include <set>

#include "loosefit/io/pvd_write.h"
#include "loosefit/io/vtp_polydata.h"
#include "loosefit/io/vtp_read.h"
#include "loosefit/io/vtp_seal.h"
#include "loosefit/io/vtp_write.h"
#include "support/scratch_folder.h"
#include "support/tube_garment.h"

namespace loosefit::io {
namespace {

TEST(VtpForOthers, VtkReadsNamedArraysAndTheirUnits) {
  const support::ScratchFolder scratch;
  const std::filesystem::path file = scratch / "others.vtp";
  const garment::Garment tube = testing::tube_garment(0.7, 0.3, 24, 6);
  const drape::Drape drape = testing::settled_drape(
      tube, [](const Vec2& uv) { return Vec3(uv.x(), 0.1 * uv.y(), 1 + uv.y()); });
  maps::PerformanceMap gap, strain;
  gap.array = "distance_mm";
  gap.unit = "mm";
  strain.array = "strain_warp";
  for (int v = 0; v < tube.vertex_count; ++v) {
    gap.values.push_back(v / 7.0);
    strain.values.push_back(v == 3 ? std::nan("") : 1e-3 * v);
  }
  write_drape_vtp(file, tube, drape, {gap, strain});

  vtkNew<vtkXMLPolyDataReader> reader;
  ASSERT_TRUE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), tube.vertex_count);
  ASSERT_EQ(data->GetNumberOfPolys(), static_cast<vtkIdType>(tube.triangles.size()));
  for (int v = 0; v < tube.vertex_count; ++v)
    EXPECT_EQ(Vec3(data->GetPoint(v)), drape.positions[v]);
  vtkDataArray* read = data->GetPointData()->GetArray("distance_mm");
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->GetTuple1(5), 5 / 7.0);
  EXPECT_TRUE(std::isnan(data->GetPointData()->GetArray("strain_warp")->GetTuple1(3)));
  EXPECT_EQ(data->GetPointData()->GetNormals()->GetNumberOfTuples(), tube.vertex_count);
  EXPECT_NE(data->GetCellData()->GetArray("panel_id"), nullptr);

  auto* units = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("units"));
  ASSERT_NE(units, nullptr);
  std::set<std::string> found;
  for (vtkIdType i = 0; i < units->GetNumberOfValues(); ++i) found.insert(units->GetValue(i));
  EXPECT_EQ(found.count("distance_mm: mm"), 1u);
  EXPECT_EQ(found.count("strain_warp: 1"), 1u) << "a strain is a number without unit";
  EXPECT_EQ(found.count("Points: m"), 1u);
}

TEST(PvdForOthers, VtkReadsTheSeriesWhateverItsNames) {
  const support::ScratchFolder scratch;
  const std::filesystem::path file = scratch / "states.pvd";
  write_pvd(file, {{"drape.vtp", 0, "reference"}, {"postures/a & \"b\"/drape.vtp", 1.5, "<bent>"}});
  vtkNew<vtkXMLDataParser> parser;
  parser->SetFileName(file.c_str());
  ASSERT_EQ(parser->Parse(), 1);
  vtkXMLDataElement* root = parser->GetRootElement();
  ASSERT_STREQ(root->GetName(), "VTKFile");
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* collection = root->GetNestedElement(0);
  ASSERT_EQ(collection->GetNumberOfNestedElements(), 2);
  EXPECT_STREQ(collection->GetNestedElement(1)->GetAttribute("file"),
               "postures/a & \"b\"/drape.vtp");
  EXPECT_STREQ(collection->GetNestedElement(1)->GetAttribute("timestep"), "1.5");
  EXPECT_STREQ(collection->GetNestedElement(0)->GetAttribute("name"), "reference");
}

/// The file as earlier versions wrote it, with what the next Newton step would do: how far a vertex
/// moves [m], how far 99 % of the normals turn [rad].
void add_left_to_go(const std::filesystem::path& file, double move, double turn) {
  const vtkSmartPointer<vtkPolyData> data = read_sealed_vtp(file, "drape.vtp");
  vtkNew<vtkDoubleArray> left;
  left->SetName("left_to_go");
  left->SetNumberOfComponents(2);
  left->InsertNextTuple2(move, turn);
  data->GetFieldData()->AddArray(left);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->Write();
  const std::string bytes = writer->GetOutputString() + "\n";
  std::ofstream(file, std::ios::binary) << bytes << vtp_seal(bytes);
}

// A drape that was at rest with a residual above that of today stays so, also once it is written
// again; one that had farther to go never was.
TEST(VtpOfEarlierVersions, ADrapeThatHadLittleLeftToGoStaysSettled) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "earlier.vtp";
  const garment::Garment tube = testing::tube_garment(0.7, 0.3, 24, 6);
  drape::Drape drape = testing::settled_drape(
      tube, [](const Vec2& uv) { return Vec3(uv.x(), 0.1 * uv.y(), 1 + uv.y()); });
  std::mt19937 random(11);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int k = 0; k < 6; ++k) {
    drape.certificate.residual = draw(1.1e-3, 0.02);
    drape.certificate.residual_max = draw(0.11, 2);
    const double move = draw(0, 1e-4), turn = draw(0, 0.2) * kPi / 180;
    write_drape_vtp(file, tube, drape);
    EXPECT_FALSE(read_drape_vtp(file).drape.certificate.settled());
    add_left_to_go(file, move, turn);
    const drape::Drape earlier = read_drape_vtp(file).drape;
    EXPECT_TRUE(earlier.certificate.settled()) << drape.certificate.residual;
    EXPECT_EQ(earlier.positions, drape.positions);
    write_drape_vtp(file, tube, earlier);
    EXPECT_TRUE(read_drape_vtp(file).drape.certificate.settled());
    for (const auto& [far, farther] : {std::pair(1.1e-4, turn), {move, radians(0.21)}}) {
      write_drape_vtp(file, tube, drape);
      add_left_to_go(file, far, farther);
      EXPECT_FALSE(read_drape_vtp(file).drape.certificate.settled());
    }
  }
}

}  // namespace
}  // namespace loosefit::io
