#include "loosefit/study/folder_plan.h"

#include <algorithm>
#include <filesystem>

#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scorecard_file.h"

namespace loosefit::study {

placement::Scorecard scorecard(const FolderPlan& plan, std::size_t modality) {
  const std::string& which = plan.modalities[modality];
  if (plan.cards.empty()) return io::load_scorecard(which);
  return io::parse_scorecard(plan.cards[modality], scorecard_names(plan)[modality] + ".toml");
}

std::string plan_sha256(const FolderPlan& plan) {
  std::string text = plan.file_sha256 + "\n";
  for (const FolderCase& one : plan.cases) text += one.address + "\n";
  return sha256_hex(text);
}

std::vector<std::string> scorecard_names(const FolderPlan& plan) {
  std::vector<std::string> names;
  for (const std::string& modality : plan.modalities)
    names.push_back(modality.find('/') == std::string::npos
                        ? modality
                        : std::filesystem::path(modality).stem().string());
  return names;
}

int people_axis(const FolderPlan& plan) {
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    if (plan.axes[k].is_people()) return static_cast<int>(k);
  return -1;
}

bool varies_by_chance(const FolderPlan& plan) {
  return std::ranges::any_of(plan.axes,
                             [](const Axis& axis) { return axis.is_people() || axis.is_drawn(); });
}

int looseness_axis(const FolderPlan& plan) {
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    if (!plan.looseness.empty() && plan.axes[k].name == plan.looseness) return static_cast<int>(k);
  return -1;
}

std::string label(const FolderPlan& plan, const FolderCase& one) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < plan.axes.size(); ++k) {
    const std::string& level = plan.axes[k].levels[one.levels[k]].label;
    words.push_back(plan.axes[k].is_people() ? level : plan.axes[k].name + " " + level);
  }
  return words.empty() ? "the base scenario" : join(words);
}

}  // namespace loosefit::study
