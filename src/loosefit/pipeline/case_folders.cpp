#include "loosefit/pipeline/case_folders.h"

namespace loosefit::pipeline {

std::filesystem::path under_folder(int garment) {
  return std::filesystem::path("under") / std::to_string(garment + 1);
}

std::filesystem::path state_folder(const StateId& id, const std::string& posture) {
  if (id.in_first_donning()) return std::filesystem::path("postures") / posture;
  return std::filesystem::path("donnings") / std::to_string(id.donning + 1) / posture;
}

}  // namespace loosefit::pipeline
