#include "ranking_handle.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "beside_python.h"
#include "case_handle.h"
#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/regions.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/pipeline/rank_case.h"
#include "loosefit/placement/site_ranking.h"
#include "loosefit/placement/site_search.h"
#include "loosefit/report/ranking_output.h"

namespace loosefit::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

/// A ranking with the pattern on which its places are marked.
struct RankingHandle {
  placement::RankingTable table;
  std::shared_ptr<const pipeline::CaseResult> first;
};
using Self = const RankingHandle&;

/// Arguments of loosefit.rank, lengths in mm as their names say.
struct Wish {
  std::string modality;
  int best = 0;
  bool partial = false, sites = true;
  double spacing_mm = 50, seam_mm = 10, edge_mm = 10;
  std::vector<std::string> keep_out, regions;
  std::uint64_t seed = 1;
};

double metres(double millimetres, const char* key) {
  constexpr double kLargest = 1e3 * placement::kLargestClearance;
  if (!(millimetres >= 0 && millimetres <= kLargest))
    throw InvalidInput({"", 0, key}, shortest(millimetres),
                       "millimetres from 0 to " + shortest(kLargest));
  return 1e-3 * millimetres;
}

body::Region region_of(const std::string& name) {
  if (const auto region = body::find_region(name)) return *region;
  throw InvalidInput({"", 0, "regions"}, "\"" + printable(name) + "\"", "a region of the body",
                     did_you_mean(name, body::region_names()));
}

placement::RankingWish ranking_wish(const Wish& wish) {
  if (wish.best < 0 || wish.best > placement::kMostPlaces)
    throw InvalidInput({"", 0, "best"}, std::to_string(wish.best),
                       "an integer from 0 to " + std::to_string(placement::kMostPlaces));
  placement::RankingWish made;
  made.scorecard = io::load_scorecard(wish.modality);
  made.best = wish.best;
  made.partial = wish.partial;
  made.constraints.spacing = metres(wish.spacing_mm, "spacing_mm");
  made.constraints.seam_clearance = metres(wish.seam_mm, "seam_mm");
  made.constraints.edge_clearance = metres(wish.edge_mm, "edge_mm");
  for (const std::string& text : wish.keep_out)
    placement::add_keep_out(text, made.constraints.keep_out);
  for (const std::string& region : wish.regions)
    made.constraints.regions.push_back(region_of(region));
  made.search.seed = made.rank.seed = wish.seed;
  return made;
}

RankingHandle rank(const std::vector<CaseHandle>& cases, const std::vector<std::string>& names,
                   const Wish& wish, const py::object& progress, const CancelToken* cancel) {
  placement::RankingWish made = ranking_wish(wish);
  std::vector<pipeline::RankedRun> runs;
  for (std::size_t i = 0; i < cases.size(); ++i)
    runs.push_back({names.at(i), cases[i].result.get()});
  RankingHandle ranked;
  ranked.first = cases.at(0).result;
  beside_python(progress, cancel, [&](Progress& told) {
    told.stage("placement");
    made.progress = [&told](double share) {
      told.check_cancelled();
      told.update(share, "search");
    };
    ranked.table = pipeline::rank_cases(runs, made, wish.sites);
  });
  return ranked;
}

/// Into the output of a run, whose ranking it then is, or into any other folder.
void write(Self self, const fs::path& folder) {
  const py::gil_scoped_release release;
  std::error_code ignored;
  io::RunFolder files = fs::exists(folder / "summary.json", ignored)
                            ? io::RunFolder::update(folder, "ranking")
                            : io::RunFolder::add(folder, "ranking");
  files.announce(report::ranking_files(self.table.scorecard.name));
  report::write_ranking(files.path(), self.table, self.first->studied().pattern.pattern);
  files.commit();
}

}  // namespace

void bind_ranking(py::module_& core) {
  py::class_<Wish>(core, "RankingWish")
      .def(py::init([](std::string modality, int best, bool sites, double spacing_mm,
                       double seam_mm, double edge_mm, std::vector<std::string> keep_out,
                       std::vector<std::string> regions, bool partial, std::uint64_t seed) {
             return Wish{std::move(modality),
                         best,
                         partial,
                         sites,
                         spacing_mm,
                         seam_mm,
                         edge_mm,
                         keep_out,
                         regions,
                         seed};
           }),
           py::kw_only(), py::arg("modality"), py::arg("best"), py::arg("sites"),
           py::arg("spacing_mm"), py::arg("seam_mm"), py::arg("edge_mm"), py::arg("keep_out"),
           py::arg("regions"), py::arg("partial"), py::arg("seed"));
  py::class_<RankingHandle>(core, "Ranking")
      .def("json", [](Self self) { return report::ranking_json(self.table); })
      .def("text", [](Self self) { return report::ranking_text(self.table); })
      .def("write", write, py::arg("folder"));
  core.def("rank", rank, py::arg("cases"), py::arg("names"), py::arg("wish"), py::arg("progress"),
           py::arg("cancel"));
  core.def(
      "ranking_of_case",
      [](const CaseHandle& of) -> std::optional<RankingHandle> {
        if (!of.ranking) return std::nullopt;
        return RankingHandle{*of.ranking, of.result};
      },
      py::arg("case"));
}

}  // namespace loosefit::python
