#include <algorithm>

#include "loosefit/maps/catalogue.h"
#include "loosefit/report/glossary.h"
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

/// A term that links lead to (defined()).
std::string term(const std::string& id, const std::string& title, const std::string& meaning) {
  return "<dt id=\"def-" + escaped(id) + "\">" + escaped(title) + "</dt>\n" +
         element("dd", meaning);
}

}  // namespace

std::string definition_section(const pipeline::CaseResult& result) {
  std::string of_maps, of_words;
  std::vector<const maps::MapArray*> shown;
  const auto add = [&](const std::vector<pipeline::CaseMap>& maps) {
    for (const pipeline::CaseMap& entry : maps) {
      const maps::MapArray* array = maps::find_map_array(entry.map.array);
      if (!array || std::find(shown.begin(), shown.end(), array) != shown.end()) continue;
      shown.push_back(array);
      of_maps += term(entry.map.array, array->style.title, text(*array));
    }
  };
  add(result.studied().maps.maps);
  for (const pipeline::CaseState& state : result.wear.states) add(state.maps.maps);
  for (const GlossaryTerm& word : glossary())
    of_words += term(word.id, word.title, escaped(word.meaning));
  std::string html;
  if (!of_maps.empty()) html += element("h2", "What the maps mean") + element("dl", of_maps);
  return html + element("h2", "What the other numbers mean") + element("dl", of_words);
}

}  // namespace loosefit::report
