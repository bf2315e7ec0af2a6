#include "loosefit/io/scenario_schema.h"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "loosefit/body/joint_postures.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/json_schema.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/toml_file.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::io {
namespace {

using Texts = std::vector<std::string>;

/// Bodies: [body], in every form that a value or the table may have.
const Texts kBodies = {"sex = 0.5\nposture = {}\ndress_posture = {}",
                       "sex = \"female\"\nposture = \"standing\"\ndress_posture = \"standing\"",
                       "file = \"scan.obj\""};

/// Keys of a garment: every kind, by size and by fit, and a file.
Texts garments() {
  Texts texts = {""};
  for (const std::string& name : kinds::drafted_kinds()) {
    const bool usual = name == kinds::garment_kinds().front().name;
    const std::string pattern = usual ? "" : "pattern = \"" + name + "\"\n";
    if (!usual) texts.push_back(pattern);
    const Texts sizes = kinds::size_names(kinds::garment_kind(name).sizes);
    if (!sizes.empty()) texts.push_back(pattern + "size = \"" + sizes.front() + "\"");
  }
  texts.push_back("pattern = \"own.json\"");
  for (std::string& text : texts)
    text +=
        "\nelastic = [{ edges = [\"front.hem\"], ratio = 0.8 }]"
        "\nband = [{ panels = [\"front\"] }]";
  return texts;
}

/// Keys of a material: a card, a file, both forms of each curve, figures of KES.
const Texts kMaterials = {"", "name = \"own.toml\"", "kes = {}",
                          "curve.warp = { elongation = [0.01], force = [1.0] }\n"
                          "curve.weft = { elongation = [0.01], force = [1.0] }\n"
                          "curve.shear = { angle = [0.01], stress = [1.0] }",
                          "curve.warp = { green_strain = [0.01], second_piola_kirchhoff = [1.0] }\n"
                          "curve.weft = { green_strain = [0.01], second_piola_kirchhoff = [1.0] }\n"
                          "curve.shear = { green_shear = [0.01], second_piola_kirchhoff = [1.0] }"};

const char* const kAttachments = R"(
[[attachment]]
kind = "board"
name = "disc"
panel = "back"
at = [0, 0]
radius = 0.01
[[attachment]]
kind = "board"
name = "rectangle"
panel = "back"
at = [0, 0]
size = [0.01, 0.01]
[[attachment]]
kind = "cable"
name = "cable"
panel = "back"
path = [[0, 0], [0, 0.1]]
)";

/// Every way to give a place, with every shape of a footprint.
std::string sites() {
  std::string text;
  int count = 0;
  for (const char* place : {"landmark = \"c7\"", "panel = \"back\"\nat = [0, 0]",
                            "segment = \"chest\"\nratios = [0, 0, 0]",
                            "segment = \"forearm\"\nside = \"left\"\nratios = [0, 0, 0]"})
    for (const char* shape :
         {"radius = 0.01", "size = [0.01, 0.01]", "length = 0.1", "girth = true"})
      text += fmt::format("[[site]]\nname = \"s{}\"\n{}\nfootprint = {{ {} }}\n", count++, place,
                          shape) +
              (shape[0] == 'r' ? "board = { size = [0.01, 0.01] }\n" : "");
  return text + "[[site]]\nname = \"line\"\nfrom = \"wrist_L\"\nto = \"elbow_L\"\n";
}

/// Scenarios that together lead through every branch of the readers. The first has every section,
/// empty, and tells the defaults.
Texts examples() {
  Texts texts = {"[body]\n" + kBodies[0] +
                 "\n[garment]\n[material]\n[simulation]\n[output]\n[ranking]\n[postures]\n"
                 "[donning]\n[[under]]\n"};
  texts.push_back(std::string(kAttachments) + sites());
  texts.push_back("[ranking]\nmodality = \"own.toml\"");
  for (const body::JointMotion& motion : body::joint_motions())
    texts.push_back(
        fmt::format("[postures]\nsweep = {{ joint = \"{}\", from = {}, to = {}, step = 90 }}",
                    motion.name, motion.low, motion.high));
  for (const std::string& body : kBodies) texts.push_back("[body]\n" + body);
  // An [[under]] has both in one table.
  for (const std::string& keys : garments())
    for (const std::string& cloth : kMaterials)
      texts.push_back("[garment]\n" + keys + "\n[material]\n" + cloth + "\n[[under]]\n" + keys +
                      "\n[under.material]\n" + cloth);
  return texts;
}

}  // namespace

std::string scenario_schema() {
  std::vector<std::shared_ptr<TableRecord>> alternatives;
  for (const std::string& text : examples()) {
    const ConfigNode table = parse_toml(text, "example");
    const auto record = std::make_shared<TableRecord>();
    ConfigReader root(table, "example", {}, record.get());
    read_scenario_root(root);
    add_alternative(alternatives, record);
  }
  return json_schema(alternatives, "Loosefit scenario",
                     "What `loosefit run` is asked for (docs/scenario.md). Lengths are in metres, "
                     "masses in kilograms, names ending in _deg in degrees.");
}

}  // namespace loosefit::io
