#include "command_material.h"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "loosefit/base/text.h"
#include "loosefit/fabric/stress_curve.h"
#include "loosefit/io/material_file.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/report/fact_documents.h"
#include "print_document.h"

namespace loosefit {
namespace {

void list_materials() {
  fmt::print("{:22} {:>8} {:>9} {:>9} {:>7} {:>9} {:>9} {:>6} {:>6} {:>6}  {}\n", "name", "w kg/m2",
             "K warp", "K weft", "G N/m", "B warp", "B weft", "c warp", "c weft", "HB/B", "");
  for (const std::string& name : io::material_names()) {
    const fabric::Material m = io::load_material(name).material;
    const double residual = std::max(m.bending_hysteresis_warp / m.bending_warp,
                                     m.bending_hysteresis_weft / m.bending_weft);
    const bool curves = !(m.curve_warp.empty() && m.curve_weft.empty() && m.curve_shear.empty());
    fmt::print("{:22} {:8.3f} {:9.4g} {:9.4g} {:7.4g} {:9.3g} {:9.3g} {:6.1f} {:6.1f} {:>6}  {}\n",
               name, m.areal_density, m.stiffness_warp, m.stiffness_weft, m.stiffness_shear,
               m.bending_warp, m.bending_weft, 1e3 * io::bending_length(m, m.bending_warp),
               1e3 * io::bending_length(m, m.bending_weft),
               residual > 0 ? fmt::format("{:.1f}", residual) : "-", curves ? "curves" : "");
  }
  fmt::print(
      "K, G N/m (of a curve: its initial slope), B N m, c bending length mm, HB/B residual "
      "curvature 1/m\n`loosefit material show NAME` tells the source\n");
}

void show_bending(const fabric::Material& m) {
  fmt::print("# bending length: warp {:.1f} mm, weft {:.1f} mm\n",
             1e3 * io::bending_length(m, m.bending_warp),
             1e3 * io::bending_length(m, m.bending_weft));
  const double warp = m.bending_hysteresis_warp / m.bending_warp;
  const double weft = m.bending_hysteresis_weft / m.bending_weft;
  if (warp > 0 || weft > 0)
    fmt::print("# residual curvature HB/B after a tight bend: warp {:.1f} 1/m, weft {:.1f} 1/m\n",
               warp, weft);
}

void show_kes(const std::vector<scenario::KesFigure>& figures) {
  if (figures.empty()) return;
  fmt::print("# as measured (KES)\n");
  for (const scenario::KesFigure& f : figures) {
    const std::string si = f.unit.factor == 1 && f.unit.unit == "-"
                               ? ""
                               : fmt::format("= {:.6g} {}", f.value * f.unit.factor,
                                             f.unit.si_unit == "-" ? "" : f.unit.si_unit);
    fmt::print("#   {:10} {:>8g} {:12} {:26} {}\n", f.key, f.value,
               f.unit.unit == "-" ? "" : f.unit.unit, si, f.unit.meaning);
  }
}

// Initial tangent and secants; the last measured strain tells where extrapolation begins.
void show_curve(const char* name, const std::vector<fabric::CurvePoint>& points,
                const char* strain) {
  if (points.empty()) return;
  const fabric::MonotoneCubic law(points);
  const double end = points.back().strain;
  std::string text = fmt::format("#   {:6} {} points to {} {:.4g}: initial {:.4g}", name,
                                 points.size(), strain, end, law.initial_slope());
  for (double at : {0.05, 0.1, 0.2})
    text += fmt::format(", to {:g} %{} {:.4g}", 100 * at, at > end ? " (beyond)" : "",
                        law.at(at).value / at);
  fmt::print("{} N/m\n", text);
}

void show_curves(const fabric::Material& m) {
  if (m.curve_warp.empty() && m.curve_weft.empty() && m.curve_shear.empty()) return;
  fmt::print("# measured curves, stiffness as force over strain:\n");
  show_curve("warp", m.curve_warp, "elongation");
  show_curve("weft", m.curve_weft, "elongation");
  show_curve("shear", m.curve_shear, "shear");
}

void show_material(const std::string& name, bool json) {
  const bool file = std::filesystem::path(name).extension() == ".toml";
  const scenario::MaterialCard card = file ? io::read_material_file(name) : io::load_material(name);
  if (json) return print_document(report::material_document(card));
  fmt::print("# {}\n# source: {}\n# status: {}\n", terminal_line(card.title),
             terminal_line(card.material.source), terminal_line(card.status));
  show_bending(card.material);
  show_kes(card.kes);
  show_curves(card.material);
  for (const std::string& note : card.notes) fmt::print("# note: {}\n", terminal_line(note));
  for (const io::ConstantInUse& c : io::constants_in_use(card))
    if (c.from != "card " + card.material.name)
      fmt::print("# {} from {}\n", c.key, terminal_line(c.from));
  fmt::print("{}", io::material_toml(card.material));
}

}  // namespace

void add_material_command(CLI::App& app) {
  CLI::App* material =
      app.add_subcommand("material", "list the fabrics, or show one with its source");
  material->require_subcommand(1);
  auto json = std::make_shared<bool>(false);
  CLI::App* list = material->add_subcommand("list", "table of all material cards");
  add_json_flag(*list, *json);
  list->callback(
      [json] { *json ? print_document(report::materials_document()) : list_materials(); });
  auto name = std::make_shared<std::string>();
  CLI::App* show = material->add_subcommand(
      "show", "constants, measured figures, curves and source of one card");
  show->add_option("NAME", *name, "name of a card, or path of a .toml card")->required();
  add_json_flag(*show, *json);
  show->callback([name, json] { show_material(*name, *json); });
}

}  // namespace loosefit
