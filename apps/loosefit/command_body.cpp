#include "command_body.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_model.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/report/fact_documents.h"
#include "loosefit/report/write_body.h"
#include "print_document.h"
#include "standard_error.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

struct Wish {
  std::string sex = "female";
  body::BodySpec spec;
  std::map<std::string, std::optional<double>> measures;
  std::optional<std::string> posture;
  std::optional<double> arm_abduction_deg, forward_bend_deg, sitting, arm_flexion_deg,
      elbow_extension, slouch, relaxed_arms;
  std::string file, units, up;
  std::string out;
  bool json = false;
};

double sex_of(const std::string& text) {
  if (text == "female") return 0;
  if (text == "male") return 1;
  std::size_t used = 0;
  double value = -1;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || !(value >= 0 && value <= 1)) {
    throw InvalidInput({"", 0, "--sex"}, "\"" + printable(text) + "\"",
                       "female, male or a number from 0 to 1");
  }
  return value;
}

bool asks_for_a_posture(const Wish& wish) {
  return wish.posture || wish.arm_abduction_deg || wish.forward_bend_deg || wish.sitting ||
         wish.arm_flexion_deg || wish.elbow_extension || wish.slouch || wish.relaxed_arms;
}

body::Posture posture_of(const Wish& wish) {
  body::Posture posture;
  try {
    posture = body::named_posture(wish.posture.value_or("standing"));
  } catch (const InvalidInput& error) {
    throw InvalidInput({"", 0, "--posture"}, "\"" + printable(*wish.posture) + "\"",
                       error.expected(), error.hint());
  }
  if (wish.arm_abduction_deg) posture.arm_abduction = radians(*wish.arm_abduction_deg);
  if (wish.forward_bend_deg) posture.forward_bend = radians(*wish.forward_bend_deg);
  if (wish.sitting) posture.sitting = *wish.sitting;
  if (wish.arm_flexion_deg) posture.arm_flexion = radians(*wish.arm_flexion_deg);
  if (wish.elbow_extension) posture.elbow_extension = *wish.elbow_extension;
  if (wish.slouch) posture.slouch = *wish.slouch;
  if (wish.relaxed_arms) posture.relaxed_arms = *wish.relaxed_arms;
  return posture;
}

void print_words(const body::Body& body, const body::BodyFit& fit);

void print_table(const std::vector<body::MeasureRow>& table) {
  if (table.empty()) return;
  fmt::print("{:<18} {:>10} {:>12} {:>9}\n", "measure", "asked [m]", "measured [m]", "off [mm]");
  for (const auto& row : table) {
    fmt::print("{:<18} {:>10.3f} {:>12.3f} {:>+9.1f}\n", row.name, row.asked, row.measured,
               1000 * (row.measured - row.asked));
  }
}

void run(Wish wish) {
  body::Body body;
  body::BodyFit fit;
  TerminalProgress shown(false, "body");
  const InterruptGuard guard(shown);
  if (!wish.file.empty()) {
    for (const auto& [name, asked] : wish.measures) {
      if (asked) throw InvalidInput({"", 0, "--" + name}, "a wish beside --file", "one of the two");
    }
    scenario::ScenarioBody wished;
    wished.file = wish.file, wished.units = wish.units, wished.up = wish.up;
    wished.as_scanned = !asks_for_a_posture(wish);
    wished.posture = posture_of(wish);
    wished.dress_posture = body::default_dress_posture(wished.posture);
    const pipeline::CaseBody made = pipeline::make_body(wished, &shown);
    body = made.body.body();
    fit.warnings = made.warnings;
    fit.parameters = made.parameters;
  } else {
    if (!wish.units.empty() || !wish.up.empty())
      throw InvalidInput({"", 0, wish.units.empty() ? "--up" : "--units"}, "it without --file",
                         "it only beside --file");
    wish.spec.sex = sex_of(wish.sex);
    for (const auto& [name, asked] : wish.measures) {
      if (!asked) continue;
      if (name == "height") {
        wish.spec.height = *asked;
      } else {
        wish.spec.measurements[name] = *asked;
      }
    }
    const body::BodyModel model = body::BodyModel::load();
    fit = body::fit_body(model, wish.spec, body::BodyDetail::subdivided, &shown);
    body = flesh::SoftBody(model, fit.parameters).in(posture_of(wish), &shown);
  }
  shown.clear();
  for (const auto& warning : fit.warnings)
    to_standard_error(fmt::format("warning: {}\n", terminal_line(warning)));
  if (!wish.json) print_words(body, fit);
  if (!wish.out.empty()) report::write_body(wish.out, body, fit);
  if (wish.json)
    print_document(report::body_document(
        body, fit,
        wish.out.empty() ? report::WrittenFiles{}
                         : report::WrittenFiles{wish.out, {"body.json", "body.obj", "body.vtp"}}));
  else if (!wish.out.empty())
    fmt::print("wrote {}/body.obj, body.vtp, body.json\n", terminal_line(wish.out));
}

void print_words(const body::Body& body, const body::BodyFit& fit) {
  print_table(fit.table);
  for (const char* name : {"height", "chest", "waist", "hip"}) {
    const auto found = body.measured.find(name);
    if (fit.table.empty() && found != body.measured.end()) {
      fmt::print("{:<18} {:>10.3f} m\n", name, found->second);
    }
  }
  fmt::print("volume {:.1f} l, about {:.1f} kg\n", 1000 * body.measured.at("volume"),
             body.measured.at("mass"));
}

std::string option_of(const std::string& measure) {
  std::string option = "--" + measure;
  for (auto& c : option) c = c == '_' ? '-' : c;
  return option;
}

}  // namespace

void add_body_command(CLI::App& app) {
  auto* command = app.add_subcommand("body", "make a body from measures, or read one from a file");
  auto wish = std::make_shared<Wish>();
  command->add_option("--sex", wish->sex, "female, male or 0 (female) … 1 (male)");
  command->add_option("--age", wish->spec.age, "years");
  for (const auto& name : body::measure_names()) {
    command->add_option(
        option_of(name), wish->measures[name],
        name == "height" ? "stature [m]; without it the model's own" : "wanted " + name + " [m]");
  }
  command->add_option("--muscle", wish->spec.muscle, "0 … 1");
  command->add_option("--proportions", wish->spec.proportions, "0 … 1");
  command->add_option("--cup", wish->spec.cup, "0 … 1");
  command->add_option("--firmness", wish->spec.firmness, "0 … 1");
  command->add_option("--posture", wish->posture, join(body::posture_names()));
  command->add_option("--arm-abduction-deg", wish->arm_abduction_deg, "upper arm to the vertical");
  command->add_option("--forward-bend-deg", wish->forward_bend_deg, "turn of the back");
  command->add_option("--sitting", wish->sitting, "0 standing … 1 sitting");
  command->add_option("--arm-flexion-deg", wish->arm_flexion_deg, "arms raised forward");
  command->add_option("--elbow-extension", wish->elbow_extension, "0 bent … 1 straight elbows");
  command->add_option("--slouch", wish->slouch, "0 upright … 1 slumped");
  command->add_option("--relaxed-arms", wish->relaxed_arms,
                      "0 arms as the model has them … 1 hanging, palms to the thighs");
  command->add_option("--file", wish->file, "body surface: OBJ, PLY or STL");
  command->add_option("--units", wish->units, "units of the file: m, cm, mm, in");
  command->add_option("--up", wish->up, "up axis of the file: y or z");
  command->add_option("-o,--output", wish->out, "folder for body.obj, body.vtp, body.json");
  add_json_flag(*command, wish->json);
  command->callback([wish] { run(*wish); });
}

}  // namespace loosefit
