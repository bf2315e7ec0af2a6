#include "loosefit/io/scenario_under.h"

#include "loosefit/base/text.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scenario_garment.h"
#include "loosefit/io/scenario_run.h"

namespace loosefit::io {

scenario::ScenarioGarment read_under_section(ConfigReader table) {
  scenario::ScenarioGarment under;
  under.spec = read_garment_keys(table);
  under.material = read_material_section(table.table("material", "its cloth"));
  under.friction = table.optional_number("friction", {0, 3, "a coefficient"},
                                         "against every garment over it; absent: mean of the "
                                         "friction_self of the two");
  table.finish();
  return under;
}

std::string under_toml(const scenario::ScenarioGarment& under) {
  std::string text = "[[under]]\n";
  if (under.friction) text += "friction = " + shortest(*under.friction) + "\n";
  return text + garment_toml(under.spec, "under") +
         "\n[under.material]\nname = " + toml_quoted(under.material.key) + "\n" +
         own_constants_toml(under.material) + material_toml(under.material.material);
}

}  // namespace loosefit::io
