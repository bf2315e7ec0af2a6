#include "loosefit/study/gallery.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/report/case_figure.h"

namespace loosefit::study {

Gallery make_gallery(const StudyFolder& folder, const FolderPlan& plan, Progress& progress) {
  report::FigureWish wish;
  wish.maps = {"distance"};
  wish.width = 220;
  wish.height = 260;
  wish.columns = plan.axes.empty() ? 1 : static_cast<int>(plan.axes.back().levels.size());
  std::set<std::string> shown;
  for (const FolderCase& one : plan.cases) {
    const std::filesystem::path output = folder.case_folder(one.address) / "output";
    std::error_code error;
    if (!std::filesystem::exists(output / "drape.vtp", error)) continue;
    const auto record = folder.record(one.address);
    if (!record || record->status != CaseStatus::done) continue;
    if (!shown.insert(one.address).second) continue;
    if (static_cast<int>(shown.size()) > kMostPictures) break;
    wish.folders.push_back(output);
    wish.labels.push_back(label(plan, one));
  }
  Gallery gallery;
  gallery.cases = static_cast<int>(wish.folders.size());
  if (wish.folders.empty()) return gallery;
  try {
    gallery.png =
        render::figure_file(report::case_figure(wish, progress), render::FigureFormat::png);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    // The statistics do not need a picture.
    gallery.why = error.what() + (error.hint().empty() ? "" : "; " + error.hint());
  }
  return gallery;
}

}  // namespace loosefit::study
