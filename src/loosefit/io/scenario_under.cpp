#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scenario_sections.h"

// [[under]], and garments as text.
namespace loosefit {

ScenarioGarment read_under_section(ConfigReader table) {
  ScenarioGarment under;
  under.spec = read_garment_keys(table);
  under.material = read_material_section(table.table("material"));
  under.friction = table.optional_number("friction", {0, 3, "a coefficient"});
  table.finish();
  return under;
}

std::string garment_toml(const GarmentSpec& garment, const std::string& section) {
  const bool named = garment.file.empty();
  std::string text = "pattern = " + toml_quoted(named ? garment.pattern : garment.file) + "\n";
  if (section == "garment") text = "[garment]\n" + text;
  if (!named) return text;
  std::vector<std::string> adapt;
  for (const std::string& name : garment.adapt) adapt.push_back(toml_quoted(name));
  text += "adapt = [" + join(adapt) + "]\n";
  if (!garment.size.empty()) return text + "size = " + toml_quoted(garment.size) + "\n";
  const ShirtFit& fit = garment.fit;
  text += "\n[" + section + ".fit]\nchest = " + shortest(fit.chest) + "\n";
  if (fit.waist) text += "waist = " + shortest(*fit.waist) + "\n";
  return text + fmt::format(
                    "hip = {}\nsleeve = {}\nwrist = {}\nneck_ease = {}\nscye_ease = {}\n"
                    "shoulder_follow = {}\ncap_ease = {}\nsleeve_length = {}\n",
                    shortest(fit.hip), shortest(fit.sleeve), shortest(fit.wrist),
                    shortest(fit.neck_ease), shortest(fit.scye_ease), shortest(fit.shoulder_follow),
                    shortest(fit.cap_ease), shortest(fit.sleeve_length));
}

std::string under_toml(const ScenarioGarment& under) {
  std::string text = "[[under]]\n";
  if (under.friction) text += "friction = " + shortest(*under.friction) + "\n";
  return text + garment_toml(under.spec, "under") +
         "\n[under.material]\nname = " + toml_quoted(under.material.key) + "\n" +
         own_constants_toml(under.material) + material_toml(under.material.material);
}

}  // namespace loosefit
