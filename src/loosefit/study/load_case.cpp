#include "loosefit/study/load_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/vtp_read.h"
#include "loosefit/study/case_boards.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/check_worn.h"
#include "loosefit/study/recall_summary.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

constexpr double kSameSkin = 1e-5;  ///< round-off of another processor, less than a map shows [m]

/// The drape of a file, if it is of this garment.
Drape read_drape(const std::filesystem::path& path, const Garment& garment) {
  DrapeFile file = read_drape_vtp(path);
  if (file.garment.triangles != garment.triangles)
    throw InvalidInput({path.string(), 0, ""}, "another garment",
                       "the mesh that scenario.toml of the run makes with this version",
                       kMakeAgain);
  return std::move(file.drape);
}

/// A drape lies on the body that it was made with: its certificate and every distance hold for that
/// one alone.
void check_body(const std::filesystem::path& path, const Body& body) {
  const TriangleMesh drawn = read_body_vtp(path);
  const std::vector<Vec3>& skin = body.surface.vertices;
  const bool same_mesh =
      drawn.triangles == body.surface.triangles && drawn.vertices.size() == skin.size();
  double farthest = 0;
  for (std::size_t i = 0; same_mesh && i < skin.size(); ++i)
    farthest = std::max(farthest, (drawn.vertices[i] - skin[i]).norm());
  if (same_mesh && farthest <= kSameSkin) return;
  throw InvalidInput({path.string(), 0, ""},
                     same_mesh
                         ? fmt::format("a body whose skin lies up to {:.2f} mm off", 1e3 * farthest)
                         : "a body of another mesh",
                     "the body that scenario.toml of the run makes with this version", kMakeAgain);
}

/// Postures and donnings; none were made when the first drape is not settled and worn.
void recall_wear(const std::filesystem::path& folder, CaseResult& result, Progress& progress) {
  result.wear = plan_wear(result.scenario);
  if (!result.drape.certificate.holds()) return;
  pose_wearers(result.body, result.wear, progress);
  const CaseWear& wear = result.wear;
  const auto is_there = [](const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::exists(file, error);
  };
  for (int d = 0; d < static_cast<int>(wear.donnings.size()); ++d)
    for (int p = d == 0 ? 1 : 0; p < static_cast<int>(wear.postures.size()); ++p) {
      CaseState state;
      state.posture = p, state.donning = d, state.name = wear.postures[p];
      const std::filesystem::path file = folder / state_folder(state) / "drape.vtp";
      if (d == 0 && (is_there(file) || is_there(file.parent_path() / "body.vtp")))
        check_body(file.parent_path() / "body.vtp", *wear.bodies[p]);
      if (is_there(file)) {
        state.drape = read_drape(file, result.mesh());
        for (int l = 0; l < static_cast<int>(result.under.size()); ++l)
          state.under.push_back(read_drape(file.parent_path() / under_folder(l) / "drape.vtp",
                                           result.under[l].mesh()));
        check_worn(result, state);
      } else {
        state.left_out = "the run has no drape of it";
      }
      result.wear.states.push_back(std::move(state));
    }
}

}  // namespace

CaseResult load_case(const std::filesystem::path& folder, Progress& progress) {
  repair_output(folder);
  StageClock clock(progress);
  CaseResult result;
  result.scenario = read_scenario((folder / "scenario.toml").string());
  clock.stage("body");
  result.body = make_body(result.scenario.body);
  check_body(folder / "body.vtp", result.body.body);
  clock.stage("pattern");
  result.under = make_under_patterns(result.scenario, result.body.body);
  result.pattern = make_pattern(result.scenario.studied().spec, result.body.body);
  clock.stage("garment");
  result.garment = build_hierarchy(result.pattern.pattern, result.scenario.simulation.edge_length,
                                   result.scenario.studied().material.material,
                                   all_attachments(result.scenario));
  mesh_under(result, result.scenario.simulation.edge_length);
  result.drape = read_drape(folder / "drape.vtp", result.mesh());
  for (int l = 0; l < static_cast<int>(result.under.size()); ++l)
    result.under[l].drape =
        read_drape(folder / under_folder(l) / "drape.vtp", result.under[l].mesh());
  check_worn(result);
  clock.stage("body");
  recall_wear(folder, result, clock);
  clock.stop();
  result.seconds = clock.entries();
  recall_summary(folder, result);
  return result;
}

}  // namespace loosefit
