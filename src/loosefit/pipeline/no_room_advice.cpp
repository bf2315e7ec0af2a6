#include "loosefit/pipeline/no_room_advice.h"

#include <vector>

#include "loosefit/base/text.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::pipeline {
namespace {

std::string less_of(const scenario::GarmentSpec& garment, const std::string& section) {
  if (garment.file.empty()) {
    if (!garment.size.empty())
      return "a smaller " + section + ".size, or " + section + ".fit in its place";
    const bool has_sizes = !kinds::garment_kind(garment.kind).sizes.empty();
    return "a smaller " + section + ".fit" +
           (has_sizes ? ", or " + section + ".size in its place" : std::string());
  }
  std::string advice = "a pattern of less width there";
  if (!garment.size.empty()) advice += ", or another " + section + ".size of its file";
  return advice + "; `loosefit pattern --file " + printable(garment.file, 200) +
         " -o DIR` writes how its panels lie and which edges are sewn: each has to lie with its "
         "outside away from the body, and sewn edges have to face each other; GarmentCode files "
         "say it "
         "by translation and rotation, a side file by what its pieces are ([pieces]), which way up "
         "they lie ([up]) and what is sewn to what ([[seam]])";
}

}  // namespace

std::string no_room_advice(const scenario::Scenario& scenario) {
  std::vector<std::string> ways = {less_of(scenario.studied().spec, "garment")};
  for (const scenario::ScenarioGarment& under : scenario.worn_under())
    ways.push_back("under it " + less_of(under.spec, "under"));
  return "what may help: " + join(ways, "; ");
}

}  // namespace loosefit::pipeline
