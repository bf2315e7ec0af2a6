#include "loosefit/io/band_table.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

const NumberRange kLayers{0.2, 20, "a multiple"};
const NumberRange kStiffness{0.02, 100, "a multiple"};

}  // namespace

pattern::NamedCloth read_band(ConfigReader table, std::set<std::string>& told) {
  pattern::NamedCloth named;
  table.only({"panels", "layers", "stiffness"});
  named.panels = table.texts("panels", ".+", "panels that are made of it", 1);
  table.require("panels", "names of panels, [\"NECKBAND\", \"CUFF_L\", \"CUFF_R\"]");
  for (const std::string& panel : named.panels)
    if (!told.insert(panel).second)
      throw table.error("panels", toml_quoted(panel), "a panel that no band before it has",
                        "each panel is of one cloth");
  const double layers =
      table.number("layers", 2, kLayers, "weight, of one layer of the garment's fabric");
  const double stiffness = table.number(
      "stiffness", 2, kStiffness,
      "in the plane, of one layer of the fabric; in bending at least 1: 2 of a folded strip");
  named.cloth = pattern::cloth_of_layers(layers, stiffness);
  table.finish();
  return named;
}

std::string band_toml(const pattern::NamedCloth& band) {
  std::vector<std::string> panels;
  for (const std::string& panel : band.panels) panels.push_back(toml_quoted(panel));
  return fmt::format("panels = [{}]\nlayers = {}\nstiffness = {}\n", join(panels),
                     shortest(band.cloth.mass), shortest(band.cloth.membrane));
}

}  // namespace loosefit::io
