#include "command_material.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "loosefit/io/material_file.h"

namespace loosefit {
namespace {

void list_materials() {
  fmt::print("{:22} {:>8} {:>9} {:>9} {:>7} {:>9} {:>9} {:>6}\n", "name", "w kg/m2", "K warp",
             "K weft", "G N/m", "B warp", "B weft", "c mm");
  for (const std::string& name : material_names()) {
    const Material m = load_material(name).material;
    fmt::print("{:22} {:8.3f} {:9.4g} {:9.4g} {:7.4g} {:9.3g} {:9.3g} {:6.1f}\n", name,
               m.areal_density, m.stiffness_warp, m.stiffness_weft, m.stiffness_shear,
               m.bending_warp, m.bending_weft, bending_length(m) * 1e3);
  }
  fmt::print("K N/m, B N m, c bending length; `loosefit material show NAME` tells the source\n");
}

void show_material(const std::string& name) {
  const MaterialCard card = load_material(name);
  fmt::print("# {}\n# source: {}\n# status: {}\n", card.title, card.material.source, card.status);
  fmt::print("# bending length: {:.1f} mm\n", bending_length(card.material) * 1e3);
  for (const std::string& note : card.notes) fmt::print("# note: {}\n", note);
  fmt::print("{}", material_toml(card.material));
}

}  // namespace

void add_material_command(CLI::App& app) {
  CLI::App* material =
      app.add_subcommand("material", "list the fabrics, or show one with its source");
  material->require_subcommand(1);
  material->add_subcommand("list", "table of all material cards")->callback(list_materials);
  auto name = std::make_shared<std::string>();
  CLI::App* show = material->add_subcommand("show", "constants and source of one card");
  show->add_option("NAME", *name, "name of the card")->required();
  show->callback([name] { show_material(*name); });
}

}  // namespace loosefit
