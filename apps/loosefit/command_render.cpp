#include "command_render.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "command_stages.h"
#include "exit_code.h"
#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/whole_file.h"
#include "loosefit/report/case_figure.h"
#include "print_document.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Arguments {
  std::vector<std::string> folders, views;
  std::vector<int> size;
  std::vector<double> range;
  std::string output;
  report::FigureWish wish;
  int frames = 0;
  double seconds = 6;
  bool overwrite = false, quiet = false, json = false;
};

/// Options that only a figure has. \throws InvalidInput when one is given without -o.
void refuse_figure_options(const CLI::App& command) {
  for (const char* option : {"--view", "--posture", "--label", "--title", "--size", "--columns",
                             "--range", "--turntable", "--seconds", "--overwrite"})
    if (command.count(option) > 0)
      throw InvalidInput({"", 0, option}, "it without -o", "-o FILE: it is for figures");
}

int render_again(const Arguments& arguments, const CLI::App& command) {
  refuse_figure_options(command);
  if (arguments.folders.size() != 1)
    throw InvalidInput({"", 0, "DIR"}, std::to_string(arguments.folders.size()) + " folders",
                       "one, or -o FILE for a figure of several");
  StageArguments again;
  again.folder = arguments.folders[0];
  again.options = {.maps = arguments.wish.maps,
                   .allow_unsettled = arguments.wish.allow_unsettled,
                   .pictures = true,
                   .report = false};
  again.quiet = arguments.quiet;
  again.json = arguments.json;
  return redo_stage(again);
}

int render_figure(const Arguments& arguments) {
  const std::filesystem::path file(arguments.output);
  const render::FigureFormat format = render::figure_format(file);
  io::check_whole_file(file, arguments.overwrite);
  if (arguments.frames > 0 && format != render::FigureFormat::png)
    throw InvalidInput({"", 0, "--turntable"}, file.filename().string(),
                       "a name that ends in .png: a turntable is an animated PNG");
  report::FigureWish wish = arguments.wish;
  wish.folders.assign(arguments.folders.begin(), arguments.folders.end());
  if (!arguments.views.empty()) wish.cameras.clear();
  for (const std::string& view : arguments.views)
    wish.cameras.push_back(render::camera_from_text(view));
  if (!arguments.size.empty()) wish.width = arguments.size[0], wish.height = arguments.size[1];
  if (!arguments.range.empty()) wish.range = {arguments.range[0], arguments.range[1]};

  TerminalProgress shown(arguments.quiet);
  InterruptGuard guard(shown);
  render::FigureSize size;
  std::string bytes;
  if (arguments.frames > 0) {
    report::Turntable made = report::turntable(wish, arguments.frames, arguments.seconds, shown);
    size = made.size;
    bytes = std::move(made.file);
  } else {
    const render::Figure figure = report::case_figure(wish, shown);
    size = render::size_of(figure);
    bytes = render::figure_file(figure, format);
  }
  io::write_whole_file(file, bytes, arguments.overwrite);
  shown.clear();
  if (arguments.json)
    print_document(report::figure_document(file, size, std::max(1, arguments.frames)));
  else if (!arguments.quiet)
    fmt::print("written: {} ({} x {} pixels)\n", terminal_line(file.string()), size.width,
               size.height);
  return kGood;
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  report::FigureWish& wish = arguments->wish;
  CLI::App* command = app.add_subcommand(
      "render", "maps, sites and pictures of a drape again; or, with -o, a figure of runs");
  command->add_option("DIR", arguments->folders, "folders of earlier runs or drapes")->required();
  command
      ->add_option("--map", wish.maps,
                   "what to map, instead of the scenario's maps; for a figure also an array "
                   "(strain_warp) or 'drape', plain cloth with its seams; may be repeated")
      ->allow_extra_args(false);
  command->add_option("-o,--output", arguments->output,
                      "figure to write: .png, or .svg or .pdf with text and legend as vectors");
  command
      ->add_option("--view", arguments->views,
                   "front, back, left, right, or AZIMUTH or AZIMUTH,ELEVATION in degrees, from "
                   "the front towards the wearer's left; may be repeated (default front)")
      ->allow_extra_args(false);
  command
      ->add_option("--posture", wish.postures,
                   "posture of the run to show (default: its reference posture); may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--label", wish.labels,
                   "name of a run in captions, one for each DIR (default: names of the folders)")
      ->allow_extra_args(false);
  command->add_option("--title", wish.title, "heading of the figure");
  command->add_option("--size", arguments->size, "of each picture, WIDTH,HEIGHT in pixels")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(50, 4000));
  command->add_option("--columns", wish.columns, "pictures beside each other")
      ->check(CLI::Range(1, 100));
  command->add_option("--range", arguments->range, "LOW,HIGH of the colours of a single array")
      ->delimiter(',')
      ->expected(2);
  command
      ->add_option("--turntable", arguments->frames,
                   "a turn about the vertical in so many frames, as animated PNG")
      ->check(CLI::Range(2, 360));
  command->add_option("--seconds", arguments->seconds, "for a turn (default 6)")
      ->check(CLI::Range(0.1, 600.0));
  command->add_flag("--overwrite", arguments->overwrite, "replace a figure that is there already");
  command->add_flag("--allow-unsettled", wish.allow_unsettled,
                    "show maps even of a drape that did not settle or is not worn");
  command->add_flag("-q,--quiet", arguments->quiet, "no progress, no result table");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, command, &exit_code] {
    exit_code =
        arguments->output.empty() ? render_again(*arguments, *command) : render_figure(*arguments);
  });
}

}  // namespace loosefit
