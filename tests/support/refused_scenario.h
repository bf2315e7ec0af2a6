#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"

namespace loosefit::support {

/// What the user reads when a scenario is refused: message and hint in one line; else "accepted".
inline std::string refusal(const std::string& text) {
  try {
    io::parse_scenario(text, "case.toml");
  } catch (const Error& error) {
    return std::string(error.what()) + " | " + error.hint();
  }
  return "accepted";
}

/// The scenario is refused with all these parts in what the user reads.
inline void expect_refused(const std::string& text, const std::vector<std::string>& parts) {
  const std::string error = refusal(text);
  for (const std::string& part : parts)
    EXPECT_NE(error.find(part), std::string::npos) << text << "\n" << error << "\nlacks " << part;
}

}  // namespace loosefit::support
