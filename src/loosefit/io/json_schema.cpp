#include "loosefit/io/json_schema.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace loosefit::io {
namespace {

using Json = nlohmann::ordered_json;
using Tables = std::vector<std::shared_ptr<TableRecord>>;

/// Whole numbers without a point.
Json bound(double value) {
  const auto whole = static_cast<long long>(value);
  return static_cast<double>(whole) == value ? Json(whole) : Json(value);
}

Json form_json(const ValueForm& form, const std::vector<std::string>& allowed) {
  Json json = {{"type", form.type}};
  if (form.low) json["minimum"] = bound(*form.low);
  if (form.high) json["maximum"] = bound(*form.high);
  if (!form.unit.empty()) json["unit"] = form.unit;
  if (form.type == "boolean") {
    if (!form.known.empty()) json = {{"const", true}};
    return json;
  }
  if (form.type == "string") {
    const std::vector<std::string>& texts = allowed.empty() ? form.known : allowed;
    if (!form.pattern.empty())
      json["pattern"] = form.pattern;
    else if (texts.empty())
      json["minLength"] = 1;
    else
      json["enum"] = texts;
    return json;
  }
  if (form.type == "array") {
    json["items"] = form_json(form.items.at(0), {});
    if (form.least > 0) json["minItems"] = form.least;
    if (form.most > 0) json["maxItems"] = form.most;
    if (form.unique) json["uniqueItems"] = true;
  }
  return json;
}

Json any_of(const Json& list) { return list.size() == 1 ? list[0] : Json{{"anyOf", list}}; }

Json tables_json(const Tables& tables);

Json key_json(const KeyRecord& key) {
  Json list = Json::array();
  for (const ValueForm& form : key.forms) list.push_back(form_json(form, key.allowed));
  Json json;
  if (!key.tables.empty() && key.list) {
    json = {{"type", "array"}, {"items", tables_json(key.tables)}, {"maxItems", key.most}};
  } else {
    if (!key.tables.empty()) {
      const Json tables = tables_json(key.tables);
      if (tables.contains("anyOf"))
        for (const Json& one : tables["anyOf"]) list.push_back(one);
      else
        list.push_back(tables);
    }
    if (list.empty()) throw std::logic_error("no form of the key " + key.name + " is known");
    json = any_of(list);
  }
  if (!key.about.empty()) json["description"] = key.about;
  if (!key.fallback.empty()) json["default"] = Json::parse(key.fallback);
  return json;
}

Json table_json(const TableRecord& table) {
  Json json = {{"type", "object"}, {"properties", Json::object()}};
  Json required = Json::array();
  for (const KeyRecord& key : table.keys) {
    json["properties"][key.name] = key_json(key);
    if (key.required) required.push_back(key.name);
  }
  if (!required.empty()) json["required"] = required;
  json["additionalProperties"] = false;
  for (const auto& [key, other] : table.needs) json["dependentRequired"][key].push_back(other);
  for (const auto& [a, b] : table.clashes)
    json["allOf"].push_back({{"not", {{"required", Json::array({a, b})}}}});
  return json;
}

Json tables_json(const Tables& tables) {
  Json list = Json::array();
  for (const auto& table : tables) list.push_back(table_json(*table));
  return any_of(list);
}

}  // namespace

std::string json_schema(const Tables& alternatives, const std::string& title,
                        const std::string& about) {
  Json json = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
               {"title", title},
               {"description", about}};
  json.update(tables_json(alternatives));
  return json.dump(1, ' ') + "\n";
}

}  // namespace loosefit::io
