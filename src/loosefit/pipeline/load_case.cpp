#include "loosefit/pipeline/load_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/io/vtp_read.h"
#include "loosefit/pipeline/case_folders.h"
#include "loosefit/pipeline/case_lines.h"
#include "loosefit/pipeline/case_sites.h"
#include "loosefit/pipeline/case_warnings.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/pipeline/draped_from.h"
#include "loosefit/pipeline/map_case.h"
#include "loosefit/pipeline/prepare_case.h"
#include "loosefit/pipeline/recall_summary.h"
#include "loosefit/pipeline/repeat_drapes.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

constexpr double kSamePlace = 1e-6;  ///< round-off of another processor, in the pattern [m]
constexpr double kSameSkin = 1e-5;   ///< round-off of another processor, less than a map shows [m]

/// Whether corners of meshes of the same triangles have the same places in the pattern.
bool lie_alike(const garment::Garment& a, const garment::Garment& b) {
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!((a.triangle_uv[t][k] - b.triangle_uv[t][k]).norm() <= kSamePlace)) return false;
  return true;
}

/// The drape of a file, if it is of this garment.
drape::Drape read_drape(const std::filesystem::path& path, const garment::Garment& garment) {
  io::DrapeFile file = io::read_drape_vtp(path);
  if (file.garment.triangles != garment.triangles || !lie_alike(file.garment, garment))
    throw InvalidInput({path.string(), 0, ""}, "another garment",
                       "the mesh that scenario.toml of the run makes with this version",
                       kMakeAgain);
  return std::move(file.drape);
}

/// One per garment, from the folder of a run or a state.
std::vector<drape::Drape> read_drapes(const std::filesystem::path& folder,
                                      const std::vector<CaseGarment>& garments) {
  std::vector<drape::Drape> drapes;
  const int studied = static_cast<int>(garments.size()) - 1;
  for (int g = 0; g < studied; ++g)
    drapes.push_back(read_drape(folder / under_folder(g) / "drape.vtp", garments[g].mesh()));
  drapes.push_back(read_drape(folder / "drape.vtp", garments[studied].mesh()));
  return drapes;
}

/// A drape lies on the body that it was made with: its certificate and every distance hold for that
/// one alone.
void check_body(const std::filesystem::path& path, const body::Body& body) {
  const geometry::TriangleMesh drawn = io::read_body_vtp(path);
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

bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

/// Postures and donnings; none were made when the reference state is not settled and worn.
CaseWear recall_wear(const std::filesystem::path& folder, const CaseResult& reference,
                     Progress& progress) {
  CaseWear wear = plan_wear(reference.scenario);
  if (!reference.certificate().holds()) return wear;
  wear.bodies = bodies_of(pose_wearers(reference.body, wear.postures, progress));
  for (const StateId& id : planned_states(wear)) {
    CaseState state{.id = id, .name = wear.postures[id.posture]};
    const std::filesystem::path here = folder / state_folder(state);
    const body::PosedBody& body =
        id.in_reference_posture() ? reference.body.body : wear.bodies[id.posture];
    if (id.in_first_donning() && (is_there(here / "drape.vtp") || is_there(here / "body.vtp")))
      check_body(here / "body.vtp", body);
    if (is_there(here / "drape.vtp")) {
      state.drapes = read_drapes(here, reference.garments);
      state = check_worn(std::move(state), body, reference);
    } else {
      state.left_out = "the run has no drape of it";
    }
    wear.states.push_back(std::move(state));
  }
  return wear;
}

void take_recalled(RecalledState recalled, CaseState& state) {
  state.seconds = recalled.seconds;
  if (!state.draped()) {
    if (!recalled.left_out.empty()) state.left_out = std::move(recalled.left_out);
    return;
  }
  drape::Drape& drape = state.drapes.back();
  drape.report = std::move(recalled.report);
  if (!drape.certificate.settled()) drape.unsettled = std::move(recalled.unsettled);
}

}  // namespace

CaseResult load_case(const std::filesystem::path& folder, Progress& progress) {
  io::repair_output(folder);
  StageClock clock(progress);
  const scenario::Scenario scenario = io::read_scenario((folder / "scenario.toml").string());
  try {
    placement::site_boards(scenario.sites);  // refuses boards to which the run has given no place
    CaseResult result = prepare_case(scenario, clock);
    check_body(folder / "body.vtp", result.body.body);
    result.take_drapes(check_worn(read_drapes(folder, result.garments), result.garments,
                                  result.scenario, result.body.body));
    doubt_putting_on(result);
    clock.stage("body");
    result.wear = recall_wear(folder, result, clock);
    clock.stop();
    result.seconds = clock.entries();

    // What only the drapes of the run could tell.
    RecalledSummary recalled = recall_summary(folder, result);
    check_draped_from(folder / "scenario.toml", recalled.draped_from, result.scenario);
    for (const StageClock::Entry& entry : recalled.seconds) result.seconds.push_back(entry);
    drape::Drape& drape = result.studied().drape;
    drape.report = std::move(recalled.report);
    if (!drape.certificate.settled()) drape.unsettled = std::move(recalled.unsettled);
    result.body.movements = std::move(recalled.movements);
    result.body.dressing_warnings = std::move(recalled.dressing_warnings);
    result.repeats = std::move(recalled.repeats);
    for (std::size_t s = 0; s < result.wear.states.size(); ++s)
      take_recalled(std::move(recalled.states[s]), result.wear.states[s]);
    result.wear.warnings = std::move(recalled.donning_warnings);
    return result;
  } catch (const InvalidInput& error) {
    throw io::in_scenario(error, scenario);
  }
}

CaseResult remap_case(CaseResult loaded, bool allow_unsettled, Progress& progress) {
  StageClock clock(progress);
  clock.stage("maps");
  loaded.take_maps(map_case(loaded, allow_unsettled));
  clock.stage("placement");
  loaded.take_sites(make_sites(loaded));
  loaded.take_lines(measure_lines(loaded));
  loaded.repeats = known_repeats(loaded);
  clock.stop();
  loaded.seconds.insert(loaded.seconds.end(), clock.entries().begin(), clock.entries().end());
  loaded.warnings = case_warnings(loaded);
  return loaded;
}

}  // namespace loosefit::pipeline
