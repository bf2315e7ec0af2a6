#include "loosefit/maps/catalogue.h"
#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string text(const maps::MapArray& array) {
  std::string html = escaped(array.meaning);
  if (!array.formula.empty()) html += " " + element("em", escaped(array.formula)) + ".";
  if (!array.source.empty()) html += " (" + escaped(array.source) + ".)";
  return html;
}

}  // namespace

std::string definition_section(const study::CaseResult& result) {
  std::string list;
  for (const study::CaseMap& entry : result.studied().maps.maps)
    if (const maps::MapArray* array = maps::find_map_array(entry.map.array))
      list += element("dt", escaped(array->style.title)) + element("dd", text(*array));
  if (list.empty()) return {};
  return element("h2", "What the maps mean") + element("dl", list);
}

}  // namespace loosefit::report
