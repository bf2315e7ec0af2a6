#include "loosefit/pipeline/case_pattern.h"

#include <algorithm>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/read_pattern.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pipeline/carry_with_scan.h"
#include "loosefit/pipeline/file_girths.h"
#include "loosefit/pipeline/units_doubt.h"

namespace loosefit::pipeline {
namespace {

/// Before anybody meshes a garment for a giant. \throws GeometryError
void check_units(const UnitsDoubt& doubt, const std::string& file,
                 std::vector<std::string>& warnings) {
  if (doubt.found.empty()) return;
  if (doubt.wears_nobody)
    throw GeometryError({file, 0, "units"}, doubt.found, "a garment for a body", doubt.hint);
  warnings.push_back(doubt.found + ": " + doubt.hint);
}

void measure_fit(CasePattern& result, const body::Body& body, const kinds::GirthsAlong& girths,
                 const kinds::NamedValues& drafted_fit, bool made_to_measure) {
  const kinds::GarmentKind& kind = kinds::garment_kind(result.pattern.kind);
  const kinds::BodyMeasures measures = kinds::known_measures(kind, body.measured, girths);
  if (kind.draft) {
    result.levels = kind.levels(result.pattern, measures, drafted_fit);
  } else {
    FileGirths of_file = file_girths(result.pattern, measures);
    result.levels = std::move(of_file.levels);
    result.girths_along = std::move(of_file.stations);
  }
  if (kind.stations)
    result.girths_along = kind.stations(result.pattern, measures,
                                        made_to_measure ? drafted_fit : kinds::NamedValues{});
  result.fit_along = fit_along(result.girths_along, body, girths);
  for (const kinds::FitLevel& level : result.levels) {
    result.girths[level.name] = level.garment;
    if (level.body && *level.body > 0) result.fit[level.name] = level.garment / *level.body - 1;
  }
}

/// Panels that are sewn to each other, directly or through others, the largest group first.
std::vector<std::vector<std::string>> sewn_groups(const pattern::Pattern& pattern) {
  std::vector<int> group(pattern.panels.size());
  std::iota(group.begin(), group.end(), 0);
  for (const pattern::Stitch& stitch : pattern.stitches) {
    const int from = group[stitch.second.panel], to = group[stitch.first.panel];
    std::replace(group.begin(), group.end(), from, to);
  }
  std::map<int, std::vector<std::string>> named;
  for (std::size_t p = 0; p < group.size(); ++p)
    named[group[p]].push_back(printable(pattern.panels[p].name));
  std::vector<std::vector<std::string>> groups;
  for (auto& entry : named) groups.push_back(std::move(entry.second));
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return groups;
}

/// Said before the simulation, which will drop what the body does not hold.
void warn_of_unsewn(CasePattern& result) {
  const auto groups = sewn_groups(result.pattern);
  if (groups.size() < 2) return;
  const std::string falls = "; what the body does not hold falls off";
  if (groups.front().size() == 1) {
    result.warnings.push_back("no panel is sewn to another" + falls);
    return;
  }
  for (std::size_t g = 1; g < groups.size(); ++g)
    result.warnings.push_back((groups[g].size() == 1
                                   ? "panel " + groups[g][0] + " is sewn to nothing"
                                   : "panels " + join(groups[g]) + " are sewn to no other panel") +
                              falls);
}

/// Errors about what is named by `key` get their place in the scenario's list `section`.
template <class Named, class Add>
void each_named(const std::vector<Named>& all, const std::string& section, const std::string& key,
                Add add) {
  for (std::size_t i = 0; i < all.size(); ++i) try {
      add(all[i]);
    } catch (const InvalidInput& error) {
      throw error.at({{}, 0, section + "[" + std::to_string(i) + "]." + key});
    }
}

}  // namespace

kinds::DraftedGarment draft_garment(const scenario::GarmentSpec& wished,
                                    const kinds::BodyMeasures& measures,
                                    const std::set<std::string>& asked) {
  const kinds::GarmentKind& kind = kinds::garment_kind(wished.kind);
  kinds::DraftRequest request{measures, wished.size, wished.fit, {}};
  for (const kinds::KindMeasure& m : kind.measures)
    if (!asked.count("measures." + m.name)) request.yielding.insert("measures." + m.name);
  for (const std::string& name : wished.adapt) request.yielding.insert("fit." + name);
  return kind.draft(request);
}

CasePattern make_pattern(const scenario::GarmentSpec& wished, const body::Body& body,
                         const kinds::GirthsAlong& girths) {
  CasePattern result;
  kinds::NamedValues fit;
  if (!wished.file.empty()) {
    io::PatternFile file = io::read_pattern(wished.file, {wished.size, wished.units}, wished.seams);
    if (!file.placed)
      throw GeometryError({wished.file, 0, ""}, file.not_placed,
                          "pieces that are sewn together and can be placed round a body",
                          file.not_placed_hint.empty()
                              ? "`loosefit pattern --file " + printable(wished.file, 200) +
                                    " --propose-seams` proposes seams to confirm"
                              : file.not_placed_hint);
    result.pattern = std::move(file.pattern);
    result.warnings = std::move(file.warnings);
    check_units(units_doubt(result.pattern, {}), wished.file, result.warnings);
    carry_with_scan(result.pattern, body, result.warnings);
    warn_of_unsewn(result);
  } else {
    const bool made_to_measure = wished.size.empty();
    kinds::DraftedGarment garment = draft_garment(
        wished, made_to_measure
                    ? kinds::draft_measures(kinds::garment_kind(wished.kind), body.measured, girths)
                    : kinds::BodyMeasures{});
    result.pattern = std::move(garment.pattern);
    result.warnings = std::move(garment.notes);
    fit = std::move(garment.fit);
  }
  each_named(wished.elastics, "elastic", "edges", [&](const pattern::NamedElastic& elastic) {
    pattern::add_elastic(result.pattern, elastic);
  });
  each_named(wished.bands, "band", "panels",
             [&](const pattern::NamedCloth& band) { pattern::set_cloth(result.pattern, band); });
  measure_fit(result, body, girths, fit, wished.file.empty() && wished.size.empty());
  if (!wished.file.empty())
    check_units(units_doubt(result.pattern, result.levels), wished.file, result.warnings);
  return result;
}

}  // namespace loosefit::pipeline
