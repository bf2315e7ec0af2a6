#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/answer.h"

namespace loosefit::pipeline {

/// Answers as the list `answers` of summary.json: sentences and values (docs/outputs.md).
std::string answers_json(const std::vector<Answer>& answers);

}  // namespace loosefit::pipeline
