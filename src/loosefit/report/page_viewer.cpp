#include "loosefit/report/page_viewer.h"

#include "loosefit/report/page_bundle.h"
#include "loosefit/report/page_places.h"
#include "loosefit/report/page_scene.h"

namespace loosefit::report {
namespace {

/// JSON that may stand inside a script element.
std::string inside_script(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (char c : json)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

bool can_be_drawn(const pipeline::CaseResult& result) {
  return has_viewer() && !result.studied().hierarchy.levels.empty() &&
         static_cast<int>(result.studied().drape.positions.size()) ==
             result.studied().mesh().vertex_count;
}

}  // namespace

bool has_viewer() { return !page_script().empty(); }

std::string viewer_head() {
  if (!has_viewer()) return {};
  return "<style>" + std::string(page_style()) +
         "</style>\n<script>try{if(document.createElement('canvas').getContext('webgl2')&&"
         "window.DecompressionStream)document.documentElement.classList.add('webgl')}"
         "catch(e){}</script>\n";
}

std::string viewer_section(const pipeline::CaseResult& result) {
  if (!can_be_drawn(result)) return {};
  return "<section id=\"viewer\" aria-label=\"The garment and its flat pattern, to be looked at "
         "from "
         "all sides\"></section>\n";
}

std::string viewer_data(const pipeline::CaseResult& result, const CaseForms& forms,
                        const placement::RankingTable* ranking) {
  if (!has_viewer()) return {};
  std::string data;
  if (can_be_drawn(result)) {
    PackedArrays arrays;
    const std::string scene = scene_json(result, forms, arrays);
    data =
        "<script type=\"application/json\" id=\"case\">" +
        inside_script("{\"sealed\":" + std::string(result.sealed() ? "true" : "false") +
                      ",\"scene\":" + scene + ",\"places\":" + places_json(result, ranking) + "}") +
        "</script>\n<script type=\"text/plain\" id=\"arrays\">" + arrays.gzip_base64() +
        "</script>\n";
  }
  return data + "<script>" + std::string(page_script()) + "</script>\n";
}

}  // namespace loosefit::report
