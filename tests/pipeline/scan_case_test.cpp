#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_model.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"
#include "support/scratch_folder.h"

namespace loosefit::pipeline {
namespace {

TEST(ScanCase, AScanIsDressedAndSettles) {
  // A person with arms at 30° as a scanner might store her: OBJ in millimetres, y up.
  const body::BodyModel model = body::BodyModel::load();
  body::BodySpec spec;
  spec.sex = 0, spec.age = 30, spec.height = 1.68;
  const body::Body known = model.build(body::fit_body(model, spec).parameters, {radians(30), 0, 0});
  const support::ScratchFolder scratch;
  const auto file = scratch / "person.obj";
  {
    std::ofstream out(file);
    for (const Vec3& p : known.surface.vertices)
      out << "v " << 1e3 * p.x() << ' ' << 1e3 * p.z() << ' ' << -1e3 * p.y() << '\n';
    for (const Triangle& t : known.surface.triangles)
      out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  const scenario::Scenario scenario =
      io::parse_scenario("[body]\nfile = \"" + file.string() + "\"\nunits = \"mm\"\nup = \"y\"\n" +
                             "[output]\nmaps = [\"distance\"]\n[simulation]\nedge_length = 0.04\n",
                         "case.toml");
  Progress silent;
  const CaseResult result = run_case(scenario, silent);
  EXPECT_TRUE(result.certificate().settled()) << result.certificate().stop_reason;
  EXPECT_FALSE(result.sites.empty());
  EXPECT_NEAR(result.studied().pattern.fit.at("chest"), scenario.studied().spec.fit.at("chest"),
              1e-3);
}

}  // namespace
}  // namespace loosefit::pipeline
