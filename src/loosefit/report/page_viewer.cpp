#include "loosefit/report/page_viewer.h"

#include <algorithm>

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

/// Half way between the front and the back of the wearer [m].
double site_middle(const pipeline::CaseResult& result) {
  double low = 0, high = 0;
  for (const Vec3& p : result.body.body->surface.vertices)
    low = std::min(low, p.y()), high = std::max(high, p.y());
  return 0.5 * (low + high);
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
  // Turned to the first answer, in a map that it is judged by.
  std::string look;
  if (!result.answers.empty()) {
    const pipeline::Answer& answer = result.answers.front();
    for (const placement::Site& site : result.sites)
      if (site.name == answer.site)
        look = std::string(" data-view=\"") +
               (site.body_point.y() > site_middle(result) ? "back" : "front") + "\"";
    if (pipeline::find_map(result.studied().maps.maps, answer.metric))
      look += " data-map=\"" + answer.metric + "\"";
  }
  return "<section id=\"viewer\"" + look +
         " aria-label=\"The garment and its flat pattern, to be looked at "
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
