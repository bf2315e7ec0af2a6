#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "loosefit/io/config_node.h"
#include "loosefit/study/axis.h"

namespace loosefit::study {

/// How the levels of the axes are combined into cases.
enum class Design {
  crossed,         ///< every level with every level
  paired,          ///< the first levels, the second ones, …; an axis of one level goes with all
  latin_hypercube  ///< as many cases as asked for; each level of every axis equally often
};
const char* name(Design design);

/// What a study file asks for (docs/studies.md).
struct StudyFile {
  std::string file;  ///< where it was read from
  std::string text;
  std::string name;
  std::uint64_t seed = 1;
  Design design = Design::crossed;
  int samples = 0;                      ///< of a Latin hypercube
  std::vector<std::string> modalities;  ///< scorecards, by name or absolute path
  /// The axis that answers "how loose may it be?", whose values are BGM, or ease that becomes one
  /// for each wearer; empty: none.
  std::string looseness;
  int looseness_line = 0;
  int sensors = 3;                  ///< up to so many are chosen together
  double spacing = 0.05;            ///< least distance between them [m]
  std::vector<std::string> not_at;  ///< sites where none is chosen
  int not_at_line = 0;              ///< where that stands
  io::ConfigNode base;              ///< table of the base scenario
  std::string base_file;            ///< where paths in it are looked for, and what messages name
  std::vector<Axis> axes;
  std::vector<io::ConfigNode> axis_nodes;  ///< as in the file, per axis
};

/// \throws IoError; InvalidInput with file, line and key for anything wrong in it, also for a key
/// of the scenario that two axes set (shifts of places add up).
StudyFile read_study_file(const std::string& path);
StudyFile parse_study_file(const std::string& text, const std::string& path);

}  // namespace loosefit::study
