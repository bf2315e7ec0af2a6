#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"

namespace loosefit::support {

/// The drape of a scenario, without maps; it has to be settled and worn.
inline pipeline::CaseResult only_draped(const std::string& scenario) {
  Progress silent;
  pipeline::RunOptions options;
  options.only_drape = true;
  pipeline::CaseResult result =
      pipeline::run_case(io::parse_scenario(scenario, "case.toml"), silent, options);
  EXPECT_TRUE(result.certificate().holds()) << result.certificate().stop_reason;
  EXPECT_EQ(result.certificate().worn_reasons, std::vector<std::string>{});
  return result;
}

}  // namespace loosefit::support
