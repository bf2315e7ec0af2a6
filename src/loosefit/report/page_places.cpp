#include "loosefit/report/page_places.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/pipeline/site_values.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/ranking_output.h"

namespace loosefit::report {
namespace {

using Json = nlohmann::ordered_json;

Json shape_json(const placement::FootprintShape& shape) {
  using Kind = placement::FootprintShape::Kind;
  switch (shape.kind) {
    case Kind::disc:
      return {{"kind", "disc"}, {"radius", shape.radius}};
    case Kind::rectangle:
      return {{"kind", "rectangle"}, {"across", shape.size.x()}, {"along", shape.size.y()}};
    case Kind::line:
      return {{"kind", "line"}, {"length", shape.length}};
    case Kind::girth:
      break;
  }
  return {{"kind", "girth"}};
}

Json at_json(const Vec2& at) { return {at.x(), at.y()}; }

Json site_json(const placement::Site& site) {
  Json values = Json::object();
  for (const auto& [name, value] : pipeline::site_values(site)) values[name] = value;
  return {{"name", spaced(site.name)},
          {"panel", site.panel},
          {"at", at_json(site.at)},
          {"region", spaced(body::name(site.region))},
          {"address", site.anatomy ? Json(spaced(site.anatomy->str())) : Json(nullptr)},
          {"angle", site.angle},
          {"shape", shape_json(site.shape)},
          {"values", values}};
}

Json ranked_json(const placement::RankingTable& table, const placement::RankedSite& site) {
  const placement::RankedPlace& place = table.places[site.index];
  const std::string rank = rank_text(site, table.ranking);
  Json all = {{"name", site.name},
              {"rank", site.score.rated() && rank != "-" ? Json(rank) : Json(nullptr)},
              {"score", site.score.rated() ? Json(site.score.robust) : Json(nullptr)},
              {"passes", site.score.rated() && site.score.robust >= table.scorecard.pass},
              {"reason", site.score.reason},
              {"panel", place.panel},
              {"at", at_json(place.at)},
              {"region", spaced(place.region)},
              {"address", place.anatomy ? Json(spaced(place.anatomy->str())) : Json(nullptr)},
              {"angle", place.angle},
              {"shape", shape_json(place.shape)},
              {"tolerance", nullptr}};
  if (place.tolerance)
    all["tolerance"] = {{"along", place.tolerance->along},
                        {"around", place.tolerance->around},
                        {"direction", at_json(place.tolerance->direction)}};
  return all;
}

/// What of a line lies in each triangle: the triangle, where it enters and where it leaves
/// (barycentric, the first two weights).
Json line_json(const pipeline::CaseLine& line) {
  const auto rounded = [](double weight) { return std::round(1e5 * weight) / 1e5; };
  Json pieces = Json::array();
  for (const lines::CoursePiece& piece : line.course.pieces)
    pieces.push_back({piece.triangle, rounded(piece.from[0]), rounded(piece.from[1]),
                      rounded(piece.to[0]), rounded(piece.to[1])});
  return {{"name", spaced(line.name)}, {"pieces", pieces}};
}

}  // namespace

std::string places_json(const pipeline::CaseResult& result, const placement::RankingTable* table) {
  Json all = {{"sites", Json::array()}, {"lines", Json::array()}, {"ranking", nullptr}};
  if (!result.studied().maps.maps.empty())
    for (const placement::Site& site : result.sites) all["sites"].push_back(site_json(site));
  for (const pipeline::CaseLine& line : result.lines) all["lines"].push_back(line_json(line));
  if (table && !table->ranking.sites.empty()) {
    Json places = Json::array();
    for (const placement::RankedSite& site : table->ranking.sites) {
      places.push_back(ranked_json(*table, site));
      places.back()["mark"] = places.size();
    }
    all["ranking"] = {{"title", table->scorecard.title},
                      {"seam_clearance", table->constraints.seam_clearance},
                      {"edge_clearance", table->constraints.edge_clearance},
                      {"places", places}};
  }
  return all.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace loosefit::report
