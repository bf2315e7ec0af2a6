#include "loosefit/io/measures_file.h"

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"

namespace loosefit {

ShirtMeasures read_measures(const std::filesystem::path& path) {
  using Json = nlohmann::json;
  constexpr std::size_t kLargestFile = 64u << 20;
  const std::string file = path.string();
  const Json json = Json::parse(read_text_file(file, kLargestFile), nullptr, false);
  if (!json.is_object())
    throw InvalidInput(InputPlace{file, 0, {}},
                       json.is_discarded() ? "text that is not JSON" : "no object",
                       "a JSON object with measures", "`loosefit body -o DIR` writes body.json");
  const bool nested = json.contains("measured");
  const Json& table = nested ? json.at("measured") : json;
  const auto get = [&](const char* name, const char* other = nullptr) {
    const InputPlace place{file, 0, nested ? std::string("measured.") + name : name};
    const char* key = table.is_object() && !table.contains(name) && other ? other : name;
    if (!table.is_object() || !table.contains(key))
      throw InvalidInput(place, "nothing", "this measure in metres");
    const Json& value = table.at(key);
    if (!value.is_number())
      throw InvalidInput(place, std::string("a value of type ") + value.type_name(), "a number");
    return value.get<double>();
  };
  return {.chest = get("chest"),
          .waist = get("waist"),
          .hip = get("hip"),
          .neck = get("neck"),
          .upper_arm = get("upper_arm"),
          .wrist = get("wrist"),
          .shoulder_breadth = get("shoulder_breadth"),
          .shoulder_slope = get("shoulder_slope"),
          .scye_depth = get("scye_depth"),
          .hps_to_waist = get("hps_to_waist"),
          .hps_to_hem = get("hps_to_hem", "hps_to_hip"),
          .arm_length = get("arm_length")};
}

}  // namespace loosefit
