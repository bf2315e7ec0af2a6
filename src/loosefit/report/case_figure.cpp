#include "loosefit/report/case_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"
#include "loosefit/base/progress_part.h"
#include "loosefit/base/text.h"
#include "loosefit/maps/catalogue.h"
#include "loosefit/maps/fit_range.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/garment_maps.h"
#include "loosefit/pipeline/load_case.h"
#include "loosefit/render/animated_png.h"
#include "loosefit/render/drape_painter.h"
#include "loosefit/render/legend.h"
#include "loosefit/report/case_pictures.h"

namespace loosefit::report {
namespace {

const char* const kReference = "reference";  ///< word for a run's reference posture, whatever it is

/// A run in one posture, with what is drawn of it.
struct Subject {
  std::string label, posture;
  const pipeline::CaseResult* run;
  const body::PosedBody* body;
  const drape::Drape* drape;
  geometry::TriangleMesh under;
  std::vector<maps::PerformanceMap> maps;  ///< no values: plain cloth

  render::DrawnDrape drawn() const {
    return {*body, run->studied().mesh(), drape->positions, under,
            marked_lines(*run, drape->positions)};
  }
};

/// Arrays that words ask for, as map and array names; an empty array name: plain cloth.
struct AskedArray {
  std::string map, array;
};

std::vector<AskedArray> asked_arrays(const std::vector<std::string>& words) {
  std::vector<AskedArray> asked;
  for (const std::string& word : words) {
    bool known = word == kPlainCloth;
    if (known) asked.push_back({});
    for (const maps::MapDefinition& map : maps::map_catalogue())
      for (const maps::MapArray& array : map.arrays)
        if (array.style.array == word || (map.name == word && array.style.pictured)) {
          if (map.needs_postures)
            throw InvalidInput({"", 0, "--map"}, word + ", which is made of several postures",
                               "one of " + join(maps::map_names(), ", "));
          asked.push_back({map.name, array.style.array});
          known = true;
        }
    if (!known)
      throw InvalidInput({"", 0, "--map"}, word,
                         std::string(kPlainCloth) + ", one of " + join(maps::map_names(), ", ") +
                             ", or an array of these");
  }
  return asked;
}

std::vector<maps::PerformanceMap> maps_of(const Subject& subject, const FigureWish& wish) {
  scenario::Scenario scenario = subject.run->scenario;
  std::vector<AskedArray> asked =
      asked_arrays(wish.maps.empty() ? scenario.output.maps : wish.maps);
  scenario.output.maps.clear();
  for (const AskedArray& array : asked)
    if (!array.map.empty() && std::find(scenario.output.maps.begin(), scenario.output.maps.end(),
                                        array.map) == scenario.output.maps.end())
      scenario.output.maps.push_back(array.map);
  std::vector<maps::PerformanceMap> made;
  if (!scenario.output.maps.empty()) {
    const pipeline::DressedGarment dressed{subject.run->studied().mesh(), *subject.drape,
                                           scenario.studied().material.material, *subject.body};
    made = pipeline::plain_maps(pipeline::make_maps(dressed, scenario, wish.allow_unsettled).maps);
  }
  std::vector<maps::PerformanceMap> drawn;
  for (const AskedArray& array : asked) {
    const auto found = std::find_if(made.begin(), made.end(),
                                    [&](const auto& map) { return map.array == array.array; });
    drawn.push_back(found == made.end() ? maps::PerformanceMap{} : *found);
  }
  return drawn;
}

/// The run in the postures of the wish. \throws InvalidInput
std::vector<Subject> subjects_of(const pipeline::CaseResult& run, const std::string& label,
                                 const FigureWish& wish) {
  const std::string reference =
      run.scenario.postures.empty() ? kReference : run.scenario.postures.front();
  std::vector<Subject> subjects;
  for (const std::string& posture :
       wish.postures.empty() ? std::vector<std::string>{reference} : wish.postures) {
    Subject subject{label, posture, &run, &run.body.body, &run.studied().drape, {}, {}};
    const pipeline::CaseState* worn = nullptr;
    if (posture != reference && posture != kReference) {
      std::vector<std::string> there = {reference};
      for (const pipeline::CaseState& state : run.wear.states) {
        if (!state.id.in_first_donning() || !state.draped()) continue;
        there.push_back(state.name);
        if (state.name == posture) worn = &state;
      }
      if (!worn)
        throw InvalidInput({label, 0, "--posture"}, posture,
                           "one that this run was draped in: " + join(there, ", "));
      subject.body = &run.body_in(worn->id.posture);
      subject.drape = &worn->drape();
    }
    subject.under = pipeline::surface_under_studied(run, worn);
    subject.maps = maps_of(subject, wish);
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

std::string label_of(const FigureWish& wish, std::size_t run) {
  if (!wish.labels.empty()) return wish.labels[run];
  const std::filesystem::path folder =
      std::filesystem::absolute(wish.folders[run]).lexically_normal();
  return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

/// Everything that is drawn, before it is.
struct Subjects {
  std::vector<pipeline::CaseResult> runs;
  std::vector<Subject> all;
  std::vector<render::FigureLegend> legends;
};

/// One legend for each array; ranges of all subjects made one. \throws InvalidInput
void set_ranges(Subjects& subjects, const FigureWish& wish) {
  std::map<std::string, std::vector<maps::ValueSpread>> spreads;
  for (const Subject& subject : subjects.all)
    for (const maps::PerformanceMap& map : subject.maps)
      if (!map.values.empty())
        spreads[map.array].push_back(
            maps::value_spread(map.values, std::vector<double>(map.values.size(), 1.0)));
  for (Subject& subject : subjects.all)
    for (maps::PerformanceMap& map : subject.maps) {
      if (map.values.empty()) continue;
      maps::fit_range(map, spreads[map.array]);
      if (wish.range) {
        std::tie(map.range_low, map.range_high) = *wish.range;
        map.breaks.clear();
        // Zero stays the middle of a signed quantity's colours only where it is that of the range.
        if (map.range_low != -map.range_high) map.diverging = false;
      }
      auto legend = std::find_if(subjects.legends.begin(), subjects.legends.end(),
                                 [&](const auto& known) { return known.style.array == map.array; });
      if (legend == subjects.legends.end())
        legend = subjects.legends.insert(legend, {map, false, false});
      const auto [lowest, highest] = render::value_range(map.values);
      legend->values_below |= lowest < map.range_low;
      legend->values_above |= highest > map.range_high;
    }
  if (wish.range && subjects.legends.size() > 1)
    throw InvalidInput({"", 0, "--range"},
                       fmt::format("one range for {} arrays", subjects.legends.size()),
                       "a single --map ARRAY");
}

void check_wish(const FigureWish& wish) {
  if (!wish.labels.empty() && wish.labels.size() != wish.folders.size())
    throw InvalidInput({"", 0, "--label"}, std::to_string(wish.labels.size()),
                       std::to_string(wish.folders.size()) + ", one for each run");
  if (wish.range && !(wish.range->first < wish.range->second))
    throw InvalidInput({"", 0, "--range"},
                       fmt::format("{:g},{:g}", wish.range->first, wish.range->second),
                       "the lower end first");
  asked_arrays(wish.maps);
}

Subjects load_subjects(const FigureWish& wish, Progress& progress) {
  check_wish(wish);
  Subjects subjects;
  progress.stage("reading");
  const double share = 1.0 / static_cast<double>(wish.folders.size());
  for (std::size_t r = 0; r < wish.folders.size(); ++r) {
    ProgressPart own(progress, share * static_cast<double>(r), share);
    own.update(0, label_of(wish, r));
    subjects.runs.push_back(pipeline::load_case(wish.folders[r], own));
  }
  progress.stage("pictures");
  for (std::size_t r = 0; r < subjects.runs.size(); ++r)
    for (Subject& subject : subjects_of(subjects.runs[r], label_of(wish, r), wish))
      subjects.all.push_back(std::move(subject));
  set_ranges(subjects, wish);
  return subjects;
}

/// What tells a picture from the others of its figure.
std::string caption(const Subjects& subjects, const Subject& subject,
                    const maps::PerformanceMap& map, const std::string& side) {
  const auto varies = [&](auto&& of) {
    return std::any_of(subjects.all.begin(), subjects.all.end(),
                       [&](const Subject& other) { return of(other) != of(subject); });
  };
  std::vector<std::string> parts;
  if (varies([](const Subject& s) { return s.label; })) parts.push_back(subject.label);
  if (varies([](const Subject& s) { return s.posture; })) parts.push_back(subject.posture);
  if (subject.maps.size() > 1) parts.push_back(map.values.empty() ? "drape" : map.title);
  if (!side.empty()) parts.push_back(side);
  return join(parts, ", ");
}

/// One figure per list of cameras; every subject is looked at once.
std::vector<render::Figure> figures_of(const Subjects& subjects, const FigureWish& wish,
                                       const std::vector<std::vector<render::Camera>>& cameras,
                                       Progress& progress) {
  const double aspect = static_cast<double>(wish.width) / wish.height;
  double frame_height = 0;
  for (const Subject& subject : subjects.all)
    for (const render::Camera& from : cameras.front())  // a turn keeps its elevation
      frame_height = std::max(frame_height, render::frame_height(subject.drawn(), aspect, from));

  std::vector<render::Figure> figures(cameras.size());
  const render::Screen screen;
  std::size_t done = 0;
  for (const Subject& subject : subjects.all) {
    render::DrapePainter painter(
        screen, subject.drawn(),
        {.width = wish.width, .height = wish.height, .frame_height = frame_height});
    for (std::size_t f = 0; f < cameras.size(); ++f) {
      // Rows by map where there are several sides, so that a row compares one quantity.
      std::vector<std::vector<render::FigurePanel>> by_map(subject.maps.size());
      for (const render::Camera& from : cameras[f]) {
        progress.check_cancelled();
        painter.look(from);
        for (std::size_t m = 0; m < subject.maps.size(); ++m) {
          const maps::PerformanceMap& map = subject.maps[m];
          by_map[m].push_back(
              {finished(map.values.empty() ? painter.cloth() : painter.map(map)),
               caption(subjects, subject, map, cameras[f].size() > 1 ? str(from) : "")});
        }
      }
      for (std::vector<render::FigurePanel>& panels : by_map)
        std::move(panels.begin(), panels.end(), std::back_inserter(figures[f].panels));
      progress.update(
          static_cast<double>(++done) / static_cast<double>(subjects.all.size() * cameras.size()),
          "pictures");
    }
  }
  for (std::size_t f = 0; f < figures.size(); ++f) {
    const int maps = static_cast<int>(subjects.all.front().maps.size());
    const int sides = static_cast<int>(cameras[f].size());
    const int count = static_cast<int>(figures[f].panels.size());
    // One run: a row of its maps, or a row per map; several: a row per run, and where each run has
    // one picture, at most four beside each other.
    const int natural = subjects.all.size() == 1 ? (sides > 1 ? sides : maps)
                        : maps * sides > 1       ? maps * sides
                                                 : std::min(count, 4);
    figures[f].columns = std::min(wish.columns > 0 ? wish.columns : natural, count);
    figures[f].title = wish.title;
    figures[f].legends = subjects.legends;
  }
  return figures;
}

}  // namespace

render::Figure case_figure(const FigureWish& wish, Progress& progress) {
  const Subjects subjects = load_subjects(wish, progress);
  return figures_of(subjects, wish, {wish.cameras}, progress).front();
}

Turntable turntable(const FigureWish& wish, int frames, double seconds, Progress& progress) {
  if (wish.cameras.size() != 1)
    throw InvalidInput({"", 0, "--view"}, std::to_string(wish.cameras.size()),
                       "one, from which the turn begins");
  const Subjects subjects = load_subjects(wish, progress);
  std::vector<std::vector<render::Camera>> turn;
  for (int f = 0; f < frames; ++f)
    turn.push_back({{wish.cameras[0].azimuth + 360.0 * f / frames, wish.cameras[0].elevation}});
  const std::vector<render::Figure> figures = figures_of(subjects, wish, turn, progress);
  std::vector<std::string> files;
  for (const render::Figure& figure : figures)
    files.push_back(render::figure_file(figure, render::FigureFormat::png));
  return {render::animated_png(files, static_cast<int>(std::lround(1000 * seconds / frames))),
          render::size_of(figures.front())};
}

std::string figure_document(const std::filesystem::path& file, render::FigureSize size,
                            int frames) {
  const nlohmann::ordered_json json = {{"file", file.string()},
                                       {"width_px", size.width},
                                       {"height_px", size.height},
                                       {"frames", frames}};
  return json_without_controls(
             json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) +
         "\n";
}

}  // namespace loosefit::report
