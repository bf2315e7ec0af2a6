#include "loosefit/pipeline/make_garment_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/plausible_measures.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/measures_file.h"
#include "loosefit/io/read_pattern.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_body.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/girths_along.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/case_pattern.h"
#include "loosefit/pipeline/file_girths.h"
#include "loosefit/pipeline/pattern_marks.h"
#include "loosefit/pipeline/units_doubt.h"

namespace loosefit::pipeline {
namespace {

void check_one_source(const GarmentPatternWish& wish) {
  // With a file, a size is one of those that the file holds.
  const int sources =
      !wish.file.empty() + (!wish.size.empty() && wish.file.empty()) + !wish.scenario.empty();
  const bool fixed = !wish.file.empty() || !wish.scenario.empty();
  if (sources > 1 || (fixed && !(wish.fit.empty() && !wish.kind)))
    throw InvalidInput({{}, 0, "pattern"}, "several sources of the pattern",
                       "one of --file, --size, --scenario, or measures with a fit");
  if (!wish.units.empty() && wish.file.empty())
    throw InvalidInput({{}, 0, "--units"}, printable(wish.units), "--file beside it");
  if (!wish.seams.empty() && wish.file.empty())
    throw InvalidInput({{}, 0, "--seams"}, printable(wish.seams), "--file beside it");
}

GarmentPattern of_scenario(const std::string& file) {
  const scenario::Scenario scenario = io::read_scenario(file);
  try {
    const CaseBody body = make_body(scenario.body);
    CasePattern result = make_pattern(scenario.studied().spec, body.body,
                                      kinds::girths_along(body.path(0).body()));
    GarmentPattern made;
    made.pattern = std::move(result.pattern);
    made.levels = std::move(result.levels);
    made.warnings = std::move(result.warnings);
    made.marks = scenario_marks(scenario);
    return made;
  } catch (const InvalidInput& error) {
    throw io::in_scenario(error, scenario);
  }
}

/// What a scenario with this wish would ask for.
scenario::GarmentSpec garment_of(const GarmentPatternWish& wish, const kinds::GarmentKind& kind) {
  scenario::GarmentSpec garment;
  garment.kind = kind.name;
  garment.size = wish.size;
  for (const kinds::KindKey& key : kind.keys) garment.adapt.push_back(key.name);
  for (const GivenValue& given : wish.fit) {
    if (std::erase(garment.adapt, given.key) == 0)
      throw InvalidInput({{}, 0, given.place}, "an option that a " + kind.title + " has not",
                         "keys of its fit: " + join(garment.adapt));
    const auto key = std::find_if(kind.keys.begin(), kind.keys.end(),
                                  [&](const auto& k) { return k.name == given.key; });
    if (!wish.size.empty() && !key->with_size)
      throw InvalidInput({{}, 0, given.place}, "a fit beside --size",
                         "a size, which fixes the garment, or a fit, which follows the body");
    garment.fit[given.key] = given.value;
  }
  return garment;
}

/// A person of a scenario without [body].
kinds::BodyMeasures measures_of_default_body(const kinds::GarmentKind& kind) {
  const CaseBody body = make_body(io::default_scenario().body);
  return kinds::draft_measures(kind, body.body->measured,
                               kinds::girths_along(body.path(0).body()));
}

/// A measure of the body that was given, by the range that bodies have everywhere, else by that of
/// the kind of garment.
void check_given(const GivenValue& given, const kinds::GarmentKind& kind) {
  const auto& people = body::plausible_measures();
  const auto known = std::find_if(people.begin(), people.end(),
                                  [&](const auto& m) { return m.name == given.key; });
  const auto own = std::find_if(kind.measures.begin(), kind.measures.end(),
                                [&](const auto& m) { return m.name == given.key; });
  io::NumberRange range{0, 0, "metres"};
  if (known != people.end())
    range = io::measure_range(given.key);
  else if (own != kind.measures.end() && own->unit == "m")
    range.low = own->low, range.high = own->high;
  else
    return;
  if (given.value >= range.low && given.value <= range.high) return;
  throw InvalidInput({{}, 0, given.place}, fmt::format("{:g}", given.value),
                     fmt::format("{} from {:g} to {:g}", range.what, range.low, range.high),
                     io::unit_hint(given.value, range));
}

}  // namespace

GarmentPattern make_garment_pattern(const GarmentPatternWish& wish) {
  check_one_source(wish);
  // A scenario brings body and garment.
  if (!wish.scenario.empty()) return of_scenario(wish.scenario);
  GarmentPattern made;
  // A pattern file tells its kind, which tells the measures that it is compared with.
  std::string kind_name = wish.kind.value_or(kinds::garment_kinds().front().name);
  bool placed = true;
  if (!wish.file.empty()) {
    io::PatternFile file = io::read_pattern(wish.file, {wish.size, wish.units}, wish.seams);
    made.pattern = std::move(file.pattern);
    made.warnings = std::move(file.warnings);
    made.about = std::move(file.about);
    made.used = std::move(file.used);
    made.unused = std::move(file.unused);
    made.notches = std::move(file.notches);
    placed = file.placed;
    if (!placed)
      made.warnings.push_back("it cannot be worn yet: " + file.not_placed + "; " +
                              (file.not_placed_hint.empty()
                                   ? "--propose-seams proposes seams to confirm"
                                   : file.not_placed_hint));
    kind_name = made.pattern.kind;
  }
  const kinds::GarmentKind& kind = kinds::garment_kind(kind_name);
  const bool has_body = !wish.body.empty() || !wish.measures.empty();
  kinds::BodyMeasures measures;
  if (!wish.body.empty())
    measures = io::read_measures(wish.body, kind.measures);
  else if (wish.size.empty() && (wish.file.empty() || has_body))
    measures = measures_of_default_body(kind);
  std::set<std::string> asked;
  for (const GivenValue& given : wish.measures) {
    check_given(given, kind);
    measures[given.key] = given.value;
    measures.along = {};  // of another person
    asked.insert("measures." + given.key);
  }
  if (!wish.file.empty()) {
    if (kind.draft)
      made.levels = kind.levels(made.pattern, measures, {});
    else if (placed && !units_doubt(made.pattern, {}).wears_nobody)
      made.levels = file_girths(made.pattern, measures).levels;
    if (const UnitsDoubt doubt = units_doubt(made.pattern, made.levels); !doubt.found.empty())
      made.warnings.push_back(doubt.found + ": " + doubt.hint);
    return made;
  }
  // A draft; a size is compared with its own body unless there is another one.
  if (!wish.size.empty()) try {
      const kinds::KindSize& size = kinds::find_size(kind.sizes, wish.size);
      if (!has_body) measures = size.measures;
    } catch (const InvalidInput& error) {
      throw error.at({{}, 0, "--size"});
    }
  kinds::DraftedGarment drafted = draft_garment(garment_of(wish, kind), measures, asked);
  made.pattern = std::move(drafted.pattern);
  made.levels = kind.levels(made.pattern, measures, drafted.fit);
  made.details = std::move(drafted.details);
  made.warnings = std::move(drafted.notes);
  return made;
}

}  // namespace loosefit::pipeline
