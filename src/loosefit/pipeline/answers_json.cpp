#include "loosefit/pipeline/answers_json.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace loosefit::pipeline {
namespace {
using Json = nlohmann::ordered_json;
}

std::string answers_json(const std::vector<Answer>& answers) {
  Json json = Json::array();
  for (const Answer& a : answers) {
    Json entry = {{"modality", a.modality},
                  {"sensor", a.sensor},
                  {"site", a.site},
                  {"asked", a.asked},
                  {"passes", a.passes ? Json(*a.passes) : Json(nullptr)},
                  {"text", a.text()}};
    for (const auto& [key, words] : {std::pair{"place", a.place},
                                     {"expectation", a.expectation},
                                     {"verdict", a.verdict},
                                     {"limit", a.limit},
                                     {"need", a.need},
                                     {"pass_mark", a.pass_mark}})
      entry[key] = words;
    entry["expected"] =
        a.metric.empty() ? Json(nullptr)
                         : Json{{"metric", a.metric},
                                {"unit", a.unit},
                                {"median", a.expected},
                                {"least", a.low},
                                {"greatest", a.high},
                                {"mesh_error", a.mesh_error ? Json(*a.mesh_error) : Json(nullptr)}};
    entry["samples"] = a.samples;
    entry["passing"] = a.passing;
    entry["people"] = a.people;
    entry["panel"] = a.panel;
    entry["u_m"] = a.at.x();
    entry["v_m"] = a.at.y();
    entry["files"] = a.files;
    json.push_back(std::move(entry));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace loosefit::pipeline
