#include "loosefit/io/measures_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/base/types.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/text_encoding.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::json;

std::string in_unit(const std::string& unit) {
  if (unit == "m") return "in metres";
  return unit == "rad" ? "in radians" : "in " + unit;
}

/// A value so far from those of people that it is in another unit; what lies a little outside is
/// the body's own, which a draft may yield.
void refuse_other_unit(double value, const kinds::KindMeasure& m, const InputPlace& place) {
  const double far = 0.5 * (m.high - m.low);
  if (value >= m.low - far && value <= m.high + far) return;
  std::string hint;
  for (const auto& [unit, factor] :
       {std::pair{"cm", 0.01}, {"mm", 0.001}, {"inches", 0.0254}, {"degrees", radians(1)}})
    if ((m.unit == "rad") == (std::string(unit) == "degrees") && hint.empty() &&
        value * factor >= m.low && value * factor <= m.high)
      hint = fmt::format("{:g} {} is {:.4g} {}", value, unit, value * factor, m.unit);
  throw InvalidInput(place, shortest(value),
                     fmt::format("this measure {}, {:g} to {:.4g}", in_unit(m.unit), m.low, m.high),
                     hint);
}

/// The first line with a decimal comma behind a colon; 0 without one.
int line_of_comma(const std::string& text) {
  static const std::regex comma(R"(:\s*-?\d+,\d)");
  std::smatch found;
  // Beyond the beginning of a large file nobody types numbers, and the search would be long.
  const std::string some = text.substr(0, 100'000);
  if (!std::regex_search(some, found, comma)) return 0;
  return 1 + static_cast<int>(std::count(some.begin(), some.begin() + found.position(), '\n'));
}

}  // namespace

kinds::NamedValues read_measures(const std::filesystem::path& path,
                                 const std::vector<kinds::KindMeasure>& measures) {
  constexpr std::size_t kLargestFile = 64u << 20;
  constexpr const char* kExpected = "a JSON object with measures";
  constexpr const char* kHint = "`loosefit body -o DIR` writes body.json";
  const std::string file = path.string();
  const std::string text = read_plain_text(file, kLargestFile);
  refuse_other_kinds(text, file, kExpected, {"a body.json"}, kHint);
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded())
    throw InvalidInput({file, line_of_comma(text), {}}, "text that is not JSON", kExpected,
                       line_of_comma(text) > 0 ? "decimals have a point: 0,95 is 0.95" : kHint);
  if (!json.is_object()) throw InvalidInput({file, 0, {}}, "no object", kExpected, kHint);
  const bool nested = json.contains("measured");
  const Json& table = nested ? json.at("measured") : json;
  const auto get = [&](const kinds::KindMeasure& m) {
    const InputPlace place{file, 0, nested ? "measured." + m.name : m.name};
    const std::string& key = table.is_object() && !table.contains(m.name) ? m.of_body : m.name;
    if (!table.is_object() || !table.contains(key))
      throw InvalidInput(place, "nothing", "this measure " + in_unit(m.unit));
    const Json& value = table.at(key);
    double number = 0;
    if (value.is_number())
      number = value.get<double>();
    else if (!value.is_string() || !number_in(value.get<std::string>(), number))
      throw InvalidInput(place, std::string("a value of type ") + value.type_name(), "a number",
                         "this measure stands " + in_unit(m.unit));
    refuse_other_unit(number, m, place);
    return number;
  };
  kinds::NamedValues values;
  const auto given = [&](const kinds::KindMeasure& m) {
    return table.is_object() && (table.contains(m.name) || table.contains(m.of_body));
  };
  for (const kinds::KindMeasure& m : measures)
    if (m.required || given(m)) values[m.name] = get(m);
  return values;
}

}  // namespace loosefit::io
