#include "loosefit/study/case_pattern.h"

#include <algorithm>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/pattern/garment_size.h"
#include "loosefit/study/carry_with_scan.h"

namespace loosefit {
namespace {

double measure(const Body& body, const std::string& name) {
  const auto found = body.measured.find(name);
  if (found == body.measured.end())
    throw InvalidInput({"", 0, "body." + name}, "no such measure on this body",
                       "one for the shirt draft",
                       "give a garment size or a pattern file instead of a fit");
  return found->second;
}

// Which body girth each garment level is compared with.
const std::map<std::string, std::string>& body_girth_of_level() {
  static const std::map<std::string, std::string> kTable = {
      {"chest", "chest"},      {"waist", "waist"}, {"hip", "hip"},
      {"sleeve", "upper_arm"}, {"wrist", "wrist"},
  };
  return kTable;
}

void compare_girths(CasePattern& result, const Body& body) {
  const auto waist_level = body.measured.find("hps_to_waist");
  result.girths =
      shirt_girths(result.pattern, waist_level == body.measured.end() ? 0 : waist_level->second);
  for (const auto& [level, girth] : result.girths) {
    const auto name = body_girth_of_level().find(level);
    if (name == body_girth_of_level().end()) continue;
    const auto measured = body.measured.find(name->second);
    if (measured != body.measured.end() && measured->second > 0)
      result.fit[level] = girth / measured->second - 1;
  }
}

/// A short sleeve ends in a cuff on the arm, not at the wrist.
void name_the_cuff(CasePattern& result, const Body& body, double sleeve_length) {
  auto girth = result.girths.extract("wrist");
  result.fit.erase("wrist");
  if (girth.empty()) return;
  girth.key() = "cuff";
  const double cuff = girth.mapped();
  result.girths.insert(std::move(girth));
  if (body.measured.count("upper_arm") && body.measured.count("wrist")) {
    ShirtMeasures arm;
    arm.upper_arm = body.measured.at("upper_arm");
    arm.wrist = body.measured.at("wrist");
    result.fit["cuff"] = cuff / arm_girth_at(arm, sleeve_length) - 1;
  }
}

/// Panels that are sewn to each other, directly or through others, the largest group first.
std::vector<std::vector<std::string>> sewn_groups(const Pattern& pattern) {
  std::vector<int> group(pattern.panels.size());
  std::iota(group.begin(), group.end(), 0);
  for (const Stitch& stitch : pattern.stitches) {
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

}  // namespace

ShirtMeasures shirt_measures(const Body& body) {
  return {.chest = measure(body, "chest"),
          .waist = measure(body, "waist"),
          .hip = measure(body, "hip"),
          .neck = measure(body, "neck"),
          .upper_arm = measure(body, "upper_arm"),
          .wrist = measure(body, "wrist"),
          .shoulder_breadth = measure(body, "shoulder_breadth"),
          .shoulder_slope = measure(body, "shoulder_slope"),
          .scye_depth = measure(body, "scye_depth"),
          .hps_to_waist = measure(body, "hps_to_waist"),
          .hps_to_hem = measure(body, "hps_to_hip"),
          .arm_length = measure(body, "arm_length")};
}

AdaptedShirt draft_garment(const GarmentSpec& wished, const ShirtMeasures& body,
                           const std::set<std::string>& asked) {
  ShirtFit fit = wished.fit;
  ShirtMeasures measures = body;
  std::set<std::string> yielding;
  for (const std::string& key : all_shirt_measures())
    if (!asked.count(key)) yielding.insert(key);
  for (const std::string& name : wished.adapt) yielding.insert("fit." + name);
  if (const auto size = garment_size(wished.size)) {
    measures = size->body;
    fit = size->fit;
    if (wished.fit.sleeve_length < 1) {
      fit.sleeve_length = wished.fit.sleeve_length;
      fit.wrist = fit.sleeve;
    }
  }
  AdaptedShirt shirt = draft_adapted_shirt(measures, fit, yielding);
  shirt.pattern.name = wished.pattern;
  return shirt;
}

CasePattern make_pattern(const GarmentSpec& wished, const Body& body) {
  CasePattern result;
  if (!wished.file.empty()) {
    PatternFile file = read_garmentcode(wished.file);
    result.pattern = std::move(file.pattern);
    result.warnings = std::move(file.warnings);
    carry_with_scan(result.pattern, body, result.warnings);
    warn_of_unsewn(result);
    compare_girths(result, body);
    return result;
  }
  AdaptedShirt shirt =
      draft_garment(wished, wished.size.empty() ? shirt_measures(body) : ShirtMeasures{});
  result.pattern = std::move(shirt.pattern);
  result.warnings = std::move(shirt.notes);
  compare_girths(result, body);
  if (shirt.fit.sleeve_length < 1) name_the_cuff(result, body, shirt.fit.sleeve_length);
  return result;
}

}  // namespace loosefit
