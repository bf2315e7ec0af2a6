#include "loosefit/report/error_document.h"

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"

namespace loosefit::report {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

std::string document(const InputPlace& place, const std::string& found, const std::string& expected,
                     const std::string& message, const std::string& hint, int exit_code) {
  const Json json = {{"error",
                      {{"place",
                        {{"file", text_or_null(place.file)},
                         {"line", place.line > 0 ? Json(place.line) : Json(nullptr)},
                         {"key", text_or_null(place.key)}}},
                       {"found", text_or_null(found)},
                       {"expected", text_or_null(expected)},
                       {"message", message},
                       {"hint", text_or_null(hint)}}},
                     {"exit_code", exit_code}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string error_document(const std::exception& error, int exit_code) {
  const auto* known = dynamic_cast<const Error*>(&error);
  const std::string hint = known ? known->hint() : "";
  const auto* input = dynamic_cast<const InvalidInput*>(&error);
  if (!input) return document({}, "", "", error.what(), hint, exit_code);
  return document(input->place(), input->found(), input->expected(), error.what(), hint, exit_code);
}

std::string error_document(const std::string& message, const std::string& hint, int exit_code) {
  return document({}, "", "", message, hint, exit_code);
}

}  // namespace loosefit::report
