#include "command_body.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/body_model.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/io/scenario_body.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/report/fact_documents.h"
#include "loosefit/report/write_body.h"
#include "print_document.h"
#include "standard_error.h"
#include "terminal_progress.h"

namespace loosefit {
namespace {

using Numbers = std::map<std::string, std::optional<double>>;

/// By the keys of [body] of a scenario, which say what is allowed.
struct Wish {
  std::optional<std::string> sex, posture;
  Numbers shape, measures, angles;
  std::string file, units, up;
  std::string out;
  bool json = false;
};

io::ConfigNode text_node(const std::string& text) {
  io::ConfigNode node;
  node.kind = io::ConfigNode::Kind::text;
  node.text = text;
  return node;
}

io::ConfigNode number_node(double value) {
  io::ConfigNode node;
  node.kind = io::ConfigNode::Kind::number;
  node.number = value;
  return node;
}

io::ConfigNode sex_node(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc() && end == text.data() + text.size();
  return number ? number_node(value) : text_node(text);
}

void add(const Numbers& given, io::ConfigNode& table) {
  for (const auto& [key, value] : given)
    if (value) table.members.emplace_back(key, number_node(*value));
}

bool any_of(const Numbers& given) {
  return std::ranges::any_of(given, [](const auto& one) { return one.second.has_value(); });
}

std::string option_of(const std::string& key) {
  std::string option = "--" + key.substr(key.rfind('.') + 1);
  std::ranges::replace(option, '_', '-');
  return option;
}

/// What a scenario with these values in [body] asks for. \throws InvalidInput naming the option.
scenario::ScenarioBody read(const Wish& wish) {
  io::ConfigNode table, measures, angles;
  if (wish.sex) table.members.emplace_back("sex", sex_node(*wish.sex));
  add(wish.shape, table);
  add(wish.measures, measures);
  table.members.emplace_back("measurements", measures);
  add(wish.angles, angles);
  // Angles change what the name says; both are checked.
  std::vector<io::ConfigNode> postures;
  if (wish.posture) postures.push_back(text_node(*wish.posture));
  if (!angles.members.empty()) postures.push_back(angles);
  if (postures.empty()) postures.push_back(text_node("standing"));
  scenario::ScenarioBody body;
  std::optional<body::Posture> named;
  try {
    for (const io::ConfigNode& posture : postures) {
      io::ConfigNode whole = table;
      whole.members.emplace_back("posture", posture);
      body = io::read_body_section({whole, ""}, {});
      if (!named) named = body.posture;
    }
  } catch (const InvalidInput& error) {
    throw error.at({"", 0, option_of(error.place().key)});
  }
  const body::Posture turned = body.posture;
  body.posture = *named;
  const auto turn = [&](const char* key, double body::Posture::*angle) {
    if (wish.angles.at(key)) body.posture.*angle = turned.*angle;
  };
  turn("arm_abduction_deg", &body::Posture::arm_abduction);
  turn("forward_bend_deg", &body::Posture::forward_bend);
  turn("sitting", &body::Posture::sitting);
  turn("arm_flexion_deg", &body::Posture::arm_flexion);
  turn("elbow_extension", &body::Posture::elbow_extension);
  turn("slouch", &body::Posture::slouch);
  turn("relaxed_arms", &body::Posture::relaxed_arms);
  return body;
}

/// A value that nobody gave is that of the model: of a scenario it is somebody's.
body::BodySpec spec_of(const Wish& wish, const scenario::ScenarioBody& read) {
  body::BodySpec spec{.sex = read.sex,
                      .measurements = read.measurements,
                      .muscle = read.muscle,
                      .proportions = read.proportions,
                      .cup = read.cup,
                      .firmness = read.firmness};
  if (wish.shape.at("age")) spec.age = read.age;
  if (wish.shape.at("height")) spec.height = read.height;
  return spec;
}

/// A scan brings its own size. \throws InvalidInput
void refuse_beside_file(const Wish& wish) {
  std::vector<std::string> given;
  if (wish.sex) given.push_back("sex");
  for (const Numbers* numbers : {&wish.shape, &wish.measures})
    for (const auto& [key, value] : *numbers)
      if (value) given.push_back(key);
  if (!given.empty())
    throw InvalidInput({"", 0, option_of(given.front())}, "a wish beside --file", "one of the two");
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
    refuse_beside_file(wish);
    scenario::ScenarioBody wished = read(wish);
    wished.file = wish.file, wished.units = wish.units, wished.up = wish.up;
    wished.as_scanned = !wish.posture && !any_of(wish.angles);
    wished.dress_posture = body::default_dress_posture(wished.posture);
    const pipeline::CaseBody made = pipeline::make_body(wished, &shown);
    body = made.body.body();
    fit.warnings = made.warnings;
    fit.parameters = made.parameters;
  } else {
    if (!wish.units.empty() || !wish.up.empty())
      throw InvalidInput({"", 0, wish.units.empty() ? "--up" : "--units"}, "it without --file",
                         "it only beside --file");
    const scenario::ScenarioBody wished = read(wish);
    const body::BodyModel model = body::BodyModel::load();
    fit = body::fit_body(model, spec_of(wish, wished), body::BodyDetail::subdivided, &shown);
    body = flesh::SoftBody(model, fit.parameters).in(wished.posture, &shown);
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

}  // namespace

void add_body_command(CLI::App& app) {
  auto* command = app.add_subcommand("body", "make a body from measures, or read one from a file");
  auto wish = std::make_shared<Wish>();
  const auto number = [&](Numbers& numbers, const std::string& key, const std::string& about) {
    command->add_option(option_of(key), numbers[key], about);
  };
  command->add_option("--sex", wish->sex, "female, male or 0 (female) … 1 (male)");
  number(wish->shape, "age", "years");
  number(wish->shape, "height", "stature [m]; without it the model's own");
  for (const std::string& name : body::measure_names())
    if (name != "height") number(wish->measures, name, "wanted " + name + " [m]");
  for (const char* key : {"muscle", "proportions", "cup", "firmness"})
    number(wish->shape, key, "0 … 1");
  command->add_option("--posture", wish->posture, join(body::posture_names()));
  number(wish->angles, "arm_abduction_deg", "upper arm to the vertical");
  number(wish->angles, "forward_bend_deg", "turn of the back");
  number(wish->angles, "sitting", "0 standing … 1 sitting");
  number(wish->angles, "arm_flexion_deg", "arms raised forward");
  number(wish->angles, "elbow_extension", "0 bent … 1 straight elbows");
  number(wish->angles, "slouch", "0 upright … 1 slumped");
  number(wish->angles, "relaxed_arms",
         "0 arms as the model has them … 1 hanging, palms to the thighs");
  command->add_option("--file", wish->file, "body surface: OBJ, PLY or STL");
  command->add_option("--units", wish->units, "units of the file: m, cm, mm, in");
  command->add_option("--up", wish->up, "up axis of the file: y or z");
  command->add_option("-o,--output", wish->out, "folder for body.obj, body.vtp, body.json");
  add_json_flag(*command, wish->json);
  command->callback([wish] { run(*wish); });
}

}  // namespace loosefit
