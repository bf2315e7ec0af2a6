#include "loosefit/report/case_pictures.h"

#include "loosefit/pipeline/case_folders.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/wear_states.h"
#include "loosefit/report/fitted_maps.h"

namespace loosefit::report {
namespace {

using Path = std::filesystem::path;

const char* const kMapFolder = "maps";

render::PictureOptions picture_options(const scenario::ScenarioOutput& asked) {
  render::PictureOptions options;
  options.width = asked.width;
  options.height = asked.height;
  options.undecorated = asked.undecorated;
  options.views.clear();
  for (const std::string& view : asked.views) options.views.push_back(render::view_from_name(view));
  return options;
}

/// Plain pictures of the other postures; further donnings look much alike.
void draw_states(const render::Screen& screen, const Path& folder,
                 const pipeline::CaseResult& result, const CaseForms& forms,
                 render::PictureOptions options, Progress& progress) {
  if (!options.undecorated) return;
  for (const pipeline::CaseState& state : result.wear.states) {
    if (!state.id.in_first_donning() || !state.draped()) continue;
    progress.check_cancelled();
    options.under = pipeline::surface_under_studied(result, &state);
    options.form = forms.in_studied(&state);
    options.marked = marked_lines(result, state.drape().positions);
    const Path own = folder / pipeline::state_folder(state);
    std::filesystem::create_directories(own);
    render::render_pictures(screen, own, result.body_in(state.id.posture), result.studied().mesh(),
                            state.drape().positions, {}, options);
  }
}

void draw_worn_under(const render::Screen& screen, const Path& folder,
                     const pipeline::CaseResult& result, const render::PictureOptions& options,
                     Progress& progress) {
  for (int g = 0; g < static_cast<int>(result.worn_under().size()); ++g) {
    progress.check_cancelled();
    const pipeline::CaseGarment& garment = result.garments[g];
    const Path own = folder / pipeline::under_folder(g);
    std::filesystem::create_directories(own);
    render::render_pictures(screen, own, result.body.body, garment.mesh(), garment.drape.positions,
                            pipeline::plain_maps(garment.maps.maps), options);
  }
}

/// What render_pictures may draw of one garment or posture.
void plan(const scenario::ScenarioOutput& output, const Path& folder, bool with_maps, bool layered,
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

std::vector<render::LineMark> marked_lines(const pipeline::CaseResult& result,
                                           const std::vector<Vec3>& positions) {
  std::vector<render::LineMark> marks;
  for (const pipeline::CaseLine& line : result.lines)
    marks.push_back({line.name, lines::in_space(result.studied().mesh(), line.course, positions)});
  return marks;
}

std::vector<render::Picture> draw_case(const Path& folder, const pipeline::CaseResult& result,
                                       const CaseForms& forms, Progress& progress) {
  render::PictureOptions options = picture_options(result.scenario.output);
  const render::Screen screen;  // before anything is written
  std::filesystem::create_directories(folder / kMapFolder);
  draw_states(screen, folder, result, forms, options, progress);
  draw_worn_under(screen, folder, result, options, progress);
  options.under = pipeline::surface_under_studied(result);
  options.form = forms.in_studied();
  const pipeline::CaseGarment& studied = result.studied();
  options.marked = marked_lines(result, studied.drape.positions);
  return render::render_pictures(screen, folder / kMapFolder, result.body.body, studied.mesh(),
                                 studied.drape.positions, fitted_maps(result), options,
                                 [&progress](double share) {
                                   progress.check_cancelled();
                                   progress.update(share, "pictures");
                                 });
}

std::vector<Path> planned_pictures(const scenario::Scenario& scenario) {
  const int under = static_cast<int>(scenario.worn_under().size());
  std::vector<Path> files;
  plan(scenario.output, kMapFolder, true, under > 0, files);
  for (int g = 0; g < under; ++g)
    plan(scenario.output, pipeline::under_folder(g), true, false, files);
  const pipeline::CaseWear wear = pipeline::plan_wear(scenario);
  for (const pipeline::StateId& id : pipeline::planned_states(wear))
    if (id.in_first_donning())
      plan(scenario.output, pipeline::state_folder(id, wear.postures[id.posture]), false, under > 0,
           files);
  return files;
}

}  // namespace loosefit::report
