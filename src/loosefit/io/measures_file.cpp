#include "loosefit/io/measures_file.h"

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {

kinds::NamedValues read_measures(const std::filesystem::path& path,
                                 const std::vector<kinds::KindMeasure>& measures) {
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
  const auto get = [&](const std::string& name, const std::string& other) {
    const InputPlace place{file, 0, nested ? "measured." + name : name};
    const std::string& key = table.is_object() && !table.contains(name) ? other : name;
    if (!table.is_object() || !table.contains(key))
      throw InvalidInput(place, "nothing", "this measure in metres");
    const Json& value = table.at(key);
    if (!value.is_number())
      throw InvalidInput(place, std::string("a value of type ") + value.type_name(), "a number");
    return value.get<double>();
  };
  kinds::NamedValues values;
  const auto given = [&](const kinds::KindMeasure& m) {
    return table.is_object() && (table.contains(m.name) || table.contains(m.of_body));
  };
  for (const kinds::KindMeasure& m : measures)
    if (m.required || given(m)) values[m.name] = get(m.name, m.of_body);
  return values;
}

}  // namespace loosefit::io
