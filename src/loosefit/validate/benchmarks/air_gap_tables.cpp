#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/progress_part.h"
#include "loosefit/maps/air_gap.h"
#include "loosefit/maps/fine_cloth.h"
#include "loosefit/validate/air_gap_cells.h"
#include "loosefit/validate/air_gap_table.h"
#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/worn_drapes.h"

// Published tables of gap and contact by region (validation/air_gap.csv): each garment and person
// is draped, and the regions are compared.
namespace loosefit::validate {
namespace {

constexpr double kEdge = 0.014;         ///< [m]
constexpr int kDonnings = 3;            ///< scans average three to six
constexpr double kPartnerEdge = 0.005;  ///< of the triangles that look for partners [m]
constexpr double kHundred = 100;

/// Rows of one garment on one person are one run.
struct Run {
  std::string key;
  std::vector<const AirGapRow*> rows;
};

std::vector<Run> runs_of(const std::vector<AirGapRow>& rows) {
  std::vector<Run> runs;
  for (const AirGapRow& row : rows) {
    if (!row.is_gate()) continue;
    const std::string key =
        fmt::format("{}|{}|{}|{}|{}|{}", row.garment, row.fabric, row.body, row.posture,
                    row.ease_chest.value_or(0), row.ease_waist.value_or(HUGE_VAL));
    auto found = std::find_if(runs.begin(), runs.end(), [&](const Run& r) { return r.key == key; });
    if (found == runs.end()) found = runs.insert(runs.end(), {key, {}});
    found->rows.push_back(&row);
  }
  return runs;
}

scenario::Scenario scenario_of(const AirGapRow& row) {
  const AirGapRow::Person person = row.person().value();
  std::string body = "sex = \"" + person.sex + "\"\n", taped;
  for (const auto& [name, metres] : person.measures) {
    if (name == "height")
      body += fmt::format("height = {}\n", metres);
    else
      taped += fmt::format("{}{} = {}", taped.empty() ? "" : ", ", name, metres);
  }
  body += "measurements = { " + taped + " }\n";
  if (!row.posture.empty()) body += "posture = \"" + row.posture + "\"\n";
  const double chest = *row.ease_chest / person.measures.at("chest");
  std::string fit = fmt::format("chest = {:.6f}", chest);
  if (const auto waist = person.measures.find("waist");
      row.ease_waist && waist != person.measures.end())
    fit += fmt::format(", waist = {:.6f}", *row.ease_waist / waist->second);
  std::string garment = fmt::format("pattern = \"{}\"\nfit = {{ {} }}\n", row.garment, fit);
  if (!row.fabric.empty()) garment += "[material]\nname = \"" + row.fabric + "\"\n";
  return worn_scenario(body, garment, kEdge, kDonnings);
}

/// Means over the donnings, as the rows ask for them.
void add_cells(const Run& run, const pipeline::CaseResult& result, std::vector<AirGapCell>& cells) {
  const std::vector<WornDrape> drapes = worn_drapes(result);
  const double n = static_cast<double>(drapes.size());
  for (const AirGapRow* row : run.rows) {
    const std::vector<body::Region> wanted = regions_named(row->region);
    const auto is_wanted = [&](body::Region region) {
      return std::find(wanted.begin(), wanted.end(), region) != wanted.end();
    };
    double gap = 0, contact = 0;
    for (const WornDrape& worn : drapes) {
      const std::vector<Vec3>& x = worn.drape.positions;
      const maps::FineCloth fine = maps::cut_finer(worn.mesh, x, worn.body, kPartnerEdge);
      const double inside =
          maps::air_gap(fine.garment, fine.positions, fine.worn, worn.half_thickness(), [&](int t) {
            return is_wanted(fine.worn.regions[fine.garment.triangles[t][0]]);
          }).mean_gap();
      gap += 1e3 / n * (inside + 2 * worn.half_thickness());  // scans see the outer face
      const std::vector<body::Region>& regions = worn.body.regions();
      contact += kHundred / n *
                 maps::contact_share(
                     worn.body, maps::skin_gaps(worn.body, worn.mesh, x, worn.half_thickness()),
                     1e-3 * row->g0.value_or(1), [&](int v) { return is_wanted(regions[v]); });
    }
    const std::string source = row->source + (row->table.empty() ? "" : " " + row->table);
    if (!std::isfinite(gap) || !std::isfinite(contact))
      throw SolverFailure(
          fmt::format("{}: {} covers nothing of {}", source, row->garment, row->region));
    if (row->gap) cells.push_back({source, "gap", "mm", *row->gap, row->gap_sd.value_or(0), gap});
    if (row->contact)
      cells.push_back(
          {source, "contact", "%", *row->contact, row->contact_sd.value_or(0), contact});
  }
}

}  // namespace

BenchmarkResult benchmark_air_gap_tables(Effort, Progress& progress) {
  BenchmarkResult result;
  const std::filesystem::path file = air_gap_table_path();
  const std::vector<AirGapRow> rows = read_air_gap_table(file);
  const std::vector<Run> runs = runs_of(rows);
  std::vector<AirGapCell> cells;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const double share = 1.0 / static_cast<double>(runs.size());
    ProgressPart own(progress, share * static_cast<double>(k), share);
    const AirGapRow& first = *runs[k].rows.front();
    try {
      add_cells(runs[k], wear(scenario_of(first), first.source + ", " + first.garment, own), cells);
    } catch (const InvalidInput& error) {
      // Ease that the garment cannot have, a person whom nobody is like: of that row.
      throw error.at({file.string(), first.line, error.place().key});
    }
  }
  const std::string mesh =
      fmt::format("{} runs of {} donnings, {:g} mm edges", runs.size(), kDonnings, 1e3 * kEdge);
  result.findings = judge_cells(cells, mesh);
  std::size_t gates = 0;
  for (const Run& run : runs) gates += run.rows.size();
  result.findings.push_back({"rows of the table that are gates, of all rows", "",
                             static_cast<double>(rows.size()), static_cast<double>(gates),
                             Finding::Gate::reported, 0, mesh});
  result.notes.push_back(
      "Tables of gap and contact by region are copied by people into validation/air_gap.csv: "
      "which, "
      "and how, docs/theory/air_gap.md 4. A row without ease or person is a band to look at, no "
      "gate.");
  return result;
}

}  // namespace loosefit::validate
