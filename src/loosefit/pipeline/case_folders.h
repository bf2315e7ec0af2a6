#pragma once
#include <filesystem>

#include "loosefit/pipeline/case_state.h"

// Where the files of a case lie in the folder of its run.
namespace loosefit::pipeline {

/// The series of all drapes of a case with several, for ParaView.
inline constexpr const char* kSeriesFile = "states.pvd";

/// Folder of a garment under the studied one, in that of a run or a state: "under/1" for garment 0,
/// the innermost, and so on.
std::filesystem::path under_folder(int garment);

/// Folder of a state: "postures/NAME" for the first donning, "donnings/2/NAME" for the second.
/// `posture`: its name.
std::filesystem::path state_folder(const StateId& id, const std::string& posture);
inline std::filesystem::path state_folder(const CaseState& state) {
  return state_folder(state.id, state.name);
}

}  // namespace loosefit::pipeline
