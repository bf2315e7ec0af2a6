#include "loosefit/report/case_pictures.h"

#include "loosefit/study/case_folders.h"
#include "loosefit/study/garment_layers.h"
#include "loosefit/study/garment_maps.h"
#include "loosefit/study/wear_states.h"

namespace loosefit {
namespace {

using Path = std::filesystem::path;

const char* const kMapFolder = "maps";

PictureOptions picture_options(const ScenarioOutput& asked) {
  PictureOptions options;
  options.width = asked.width;
  options.height = asked.height;
  options.undecorated = asked.undecorated;
  options.views.clear();
  for (const std::string& view : asked.views) options.views.push_back(view_from_name(view));
  return options;
}

/// Plain pictures of the other postures; further donnings look much alike.
void draw_states(const Path& folder, const CaseResult& result, PictureOptions options,
                 Progress& progress) {
  if (!options.undecorated) return;
  for (const CaseState& state : result.wear.states) {
    if (!state.id.in_first_donning() || !state.draped()) continue;
    progress.check_cancelled();
    options.under = surface_under_studied(result, &state);
    render_pictures(folder / state_folder(state), result.body_in(state.id.posture),
                    result.studied().mesh(), state.drape().positions, {}, options);
  }
}

void draw_worn_under(const Path& folder, const CaseResult& result, const PictureOptions& options,
                     Progress& progress) {
  for (int g = 0; g < static_cast<int>(result.worn_under().size()); ++g) {
    progress.check_cancelled();
    const CaseGarment& garment = result.garments[g];
    render_pictures(folder / under_folder(g), result.body.body, garment.mesh(),
                    garment.drape.positions, plain_maps(garment.maps.maps), options);
  }
}

/// What render_pictures may draw of one garment or posture.
void plan(const ScenarioOutput& output, const Path& folder, bool with_maps, bool layered,
          std::vector<Path>& files) {
  std::vector<std::string> names;
  if (with_maps) names = output.maps;
  if (output.undecorated) names.push_back("drape");
  if (output.undecorated && layered) names.push_back("layers");
  for (const std::string& name : names)
    for (const std::string& view : output.views)
      files.push_back(folder / (name + "-" + view + ".png"));
}

}  // namespace

std::vector<Picture> draw_case(const Path& folder, const CaseResult& result, Progress& progress) {
  PictureOptions options = picture_options(result.scenario.output);
  std::filesystem::create_directories(folder / kMapFolder);
  draw_states(folder, result, options, progress);
  draw_worn_under(folder, result, options, progress);
  options.under = surface_under_studied(result);
  const CaseGarment& studied = result.studied();
  return render_pictures(folder / kMapFolder, result.body.body, studied.mesh(),
                         studied.drape.positions, plain_maps(studied.maps.maps), options,
                         [&progress](double share) {
                           progress.check_cancelled();
                           progress.update(share, "pictures");
                         });
}

std::vector<Path> planned_pictures(const Scenario& scenario) {
  const int under = static_cast<int>(scenario.worn_under().size());
  std::vector<Path> files;
  plan(scenario.output, kMapFolder, true, under > 0, files);
  for (int g = 0; g < under; ++g) plan(scenario.output, under_folder(g), true, false, files);
  const CaseWear wear = plan_wear(scenario);
  for (const StateId& id : planned_states(wear))
    if (id.in_first_donning())
      plan(scenario.output, state_folder(id, wear.postures[id.posture]), false, under > 0, files);
  return files;
}

}  // namespace loosefit
