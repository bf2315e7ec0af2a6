#include "case_handle.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "beside_python.h"
#include "body_handle.h"
#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/maps/catalogue.h"
#include "loosefit/pipeline/load_case.h"
#include "loosefit/pipeline/summary.h"
#include "loosefit/report/run_into_folder.h"
#include "loosefit/report/write_output.h"
#include "worn_handle.h"

namespace loosefit::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;
using Self = const CaseHandle&;

CaseHandle handle_of(pipeline::CaseResult result, std::optional<placement::RankingTable> ranking) {
  return {std::make_shared<const pipeline::CaseResult>(std::move(result)), std::move(ranking)};
}

std::optional<placement::RankingTable> table_of(std::optional<report::TimedRanking> ranking) {
  if (!ranking) return std::nullopt;
  return std::move(ranking->table);
}

/// Without a folder nothing is written.
CaseHandle run(const scenario::Scenario& scenario, const std::optional<fs::path>& folder,
               bool pictures, bool allow_unsettled, const py::object& progress,
               const CancelToken* cancel) {
  const pipeline::RunOptions options{.allow_unsettled = allow_unsettled};
  CaseHandle made;
  beside_python(progress, cancel, [&](Progress& told) {
    if (folder) {
      report::FolderOutput output =
          report::run_into_folder(scenario, *folder, options, pictures, told);
      made = handle_of(std::move(output.result), std::move(output.ranking));
      return;
    }
    pipeline::CaseResult result = pipeline::run_case(scenario, told, options);
    auto ranking = table_of(report::rank_as_asked(result, told));
    made = handle_of(std::move(result), std::move(ranking));
  });
  return made;
}

/// Maps and sites of a case anew, by other maps when there are any.
CaseHandle mapped_again(pipeline::CaseResult draped, const std::vector<std::string>& maps,
                        bool allow_unsettled, Progress& progress) {
  if (!maps.empty()) draped.scenario.output.maps = maps;
  pipeline::CaseResult result = pipeline::remap_case(std::move(draped), allow_unsettled, progress);
  auto ranking = table_of(report::rank_as_asked(result, progress));
  return handle_of(std::move(result), std::move(ranking));
}

/// An earlier output; without maps while it is sealed.
CaseHandle load(const fs::path& folder, bool allow_unsettled, const py::object& progress,
                const CancelToken* cancel) {
  CaseHandle made;
  beside_python(progress, cancel, [&](Progress& told) {
    pipeline::CaseResult loaded = pipeline::load_case(folder, told);
    made = loaded.certificate().holds() || allow_unsettled
               ? mapped_again(std::move(loaded), {}, allow_unsettled, told)
               : handle_of(std::move(loaded), std::nullopt);
  });
  return made;
}

CaseHandle remapped(Self self, const std::vector<std::string>& maps, bool allow_unsettled,
                    const py::object& progress, const CancelToken* cancel) {
  for (const std::string& map : maps)
    if (std::ranges::find(maps::map_names(), map) == maps::map_names().end())
      throw InvalidInput({"", 0, "maps"}, "\"" + printable(map) + "\"", "the name of a map",
                         did_you_mean(map, maps::map_names()));
  CaseHandle made;
  beside_python(progress, cancel, [&](Progress& told) {
    made = mapped_again(*self.result, maps, allow_unsettled, told);
  });
  return made;
}

void write(Self self, const fs::path& folder, bool pictures, const py::object& progress,
           const CancelToken* cancel) {
  beside_python(progress, cancel, [&](Progress& told) {
    const report::OutputParts parts{.pictures = pictures};
    io::RunFolder files = io::RunFolder::create(folder);
    files.announce(report::planned_files(self.result->scenario, parts));
    std::optional<report::TimedRanking> ranking;
    if (self.ranking) ranking = report::TimedRanking{*self.ranking};
    report::write_output(files.path(), *self.result, parts, ranking, told);
    told.check_cancelled();
    files.commit();
  });
}

py::dict dict_of(const drape::Certificate& c, const pipeline::PuttingOn& putting_on) {
  py::dict row;
  row["settled"] = c.settled();
  row["worn"] = c.worn();
  row["worn_reasons"] = c.worn_reasons;
  row["can_be_put_on"] = putting_on.possible;
  row["can_be_put_on_reasons"] = putting_on.reasons;
  row["residual"] = c.residual;
  row["residual_max"] = c.residual_max;
  row["intersections_body"] = c.intersections_body;
  row["intersections_self"] = c.intersections_self;
  row["intersections_layers"] = c.intersections_layers;
  row["folded_edges"] = c.folded_edges;
  row["stable"] = c.stable;
  row["stop_reason"] = c.stop_reason;
  return row;
}

py::list states(Self self) {
  py::list rows;
  for (const pipeline::CaseState& state : self.result->wear.states) {
    py::dict row = dict_of(state.certificate(), self.result->putting_on);
    if (!state.draped()) row["worn"] = py::none();
    row["posture"] = state.name;
    row["donning"] = state.id.donning + 1;
    row["counts"] = state.counts();
    row["draped"] = state.draped();
    row["left_out"] = state.left_out;
    rows.append(row);
  }
  return rows;
}

BodyHandle body_of(Self self) {
  const pipeline::CaseBody& body = self.result->body;
  BodyHandle handle{shared_body(body.body), {}};
  handle.fit.table = body.asked;
  handle.fit.warnings = body.warnings;
  handle.fit.parameters = body.parameters;
  return handle;
}

BodyHandle body_of_state(Self self, int state) {
  BodyHandle handle = body_of(self);
  const int posture = self.result->wear.states.at(state).id.posture;
  handle.body = shared_body(self.result->body_in(posture));
  return handle;
}

}  // namespace

void bind_case(py::module_& core) {
  py::class_<CaseHandle>(core, "Case")
      .def("scenario", [](Self self) { return io::scenario_toml(self.result->scenario); })
      .def("summary", [](Self self) { return pipeline::summary_json(*self.result); })
      .def("certificate",
           [](Self self) { return dict_of(self.result->certificate(), self.result->putting_on); })
      .def("why",
           [](Self self) {
             const auto& unsettled = self.result->studied().drape.unsettled;
             return unsettled ? std::pair(unsettled->why, unsettled->hint)
                              : std::pair(std::string(), std::string());
           })
      .def("sealed", [](Self self) { return self.result->sealed(); })
      .def("warnings", [](Self self) { return self.result->warnings; })
      .def("garment_count", [](Self self) { return self.result->garments.size(); })
      .def(
          "worn", [](Self self, int garment) { return worn_in_reference(self.result, garment); },
          py::arg("garment"))
      .def("states", states)
      .def(
          "worn_in_state",
          [](Self self, int state, int garment) {
            return worn_in_state(self.result, state, garment);
          },
          py::arg("state"), py::arg("garment"))
      .def("body", body_of)
      .def("body_of_state", body_of_state, py::arg("state"))
      .def("remapped", remapped, py::arg("maps"), py::arg("allow_unsettled"), py::arg("progress"),
           py::arg("cancel"))
      .def("write", write, py::arg("folder"), py::arg("pictures"), py::arg("progress"),
           py::arg("cancel"));
  core.def("run", run, py::arg("scenario"), py::arg("folder"), py::arg("pictures"),
           py::arg("allow_unsettled"), py::arg("progress"), py::arg("cancel"));
  core.def("load", load, py::arg("folder"), py::arg("allow_unsettled"), py::arg("progress"),
           py::arg("cancel"));
}

}  // namespace loosefit::python
