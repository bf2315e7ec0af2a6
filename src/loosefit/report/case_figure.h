#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/render/figure.h"
#include "loosefit/render/view.h"

namespace loosefit::report {

/// Word for plain cloth among the maps of a figure.
inline constexpr const char* kPlainCloth = "drape";

/// What a figure of runs shows: every run in every posture, with every map, from every side, all to
/// one scale and each map in one range, so that pictures can be compared.
struct FigureWish {
  std::vector<std::filesystem::path> folders;  ///< of earlier runs, one at least
  std::vector<std::string> labels;             ///< one per folder; empty: the names of the folders
  /// Maps ("strain": all of its arrays that are pictured), arrays ("strain_warp"), kPlainCloth;
  /// empty: the maps of each run's scenario that are pictured.
  std::vector<std::string> maps;
  std::vector<std::string> postures;  ///< draped in the run; empty: the reference posture
  std::vector<render::Camera> cameras = {{}};
  int width = 700, height = 800;  ///< of one picture [pixels]
  int columns = 0;                ///< 0: all that is seen of one run beside each other
  std::optional<std::pair<double, double>> range;  ///< instead of the fixed ones; of one array only
  std::string title;
  bool allow_unsettled = false;
};

/// A figure for a paper. \throws InvalidInput for a word that is no map, a posture that a run has
/// not, or a range for several arrays; NoScreen; as pipeline::load_case; Error for a drape that is
/// not settled and worn, unless allowed; Cancelled.
render::Figure case_figure(const FigureWish& wish, Progress& progress);

/// A turn about the vertical in `frames` figures, from the only camera on, in `seconds`.
/// \throws as case_figure; InvalidInput for several cameras.
struct Turntable {
  std::string file;  ///< bytes of an animated PNG
  render::FigureSize size;
};
Turntable turntable(const FigureWish& wish, int frames, double seconds, Progress& progress);

/// What `loosefit render --json` says of a figure; keys in docs/command-line.md.
std::string figure_document(const std::filesystem::path& file, render::FigureSize size, int frames);

}  // namespace loosefit::report
