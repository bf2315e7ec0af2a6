#include "loosefit/report/page_scene.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "loosefit/maps/catalogue.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/placement/address.h"
#include "loosefit/render/colour_table.h"
#include "loosefit/render/garment_lines.h"
#include "loosefit/report/fitted_maps.h"
#include "loosefit/report/html.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/slip_arrows.h"

namespace loosefit::report {
namespace {

using Json = nlohmann::ordered_json;

/// Triangles of the sheet: a vertex of the garment has one corner on each piece that it lies on, so
/// that one list of triangles serves the flat pattern and the worn garment.
struct Sheet {
  std::vector<int> vertex, panel, triangles;
  std::vector<Vec2> uv;
};

Sheet make_sheet(const garment::Garment& garment) {
  Sheet sheet;
  std::map<std::tuple<int, int, double, double>, int> known;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int vertex = garment.triangles[t][k], panel = garment.triangle_panel[t];
      const Vec2& uv = garment.triangle_uv[t][k];
      const auto [at, is_new] =
          known.emplace(std::tuple(vertex, panel, uv.x(), uv.y()), sheet.vertex.size());
      if (is_new) {
        sheet.vertex.push_back(vertex);
        sheet.panel.push_back(panel);
        sheet.uv.push_back(uv);
      }
      sheet.triangles.push_back(at->second);
    }
  return sheet;
}

double tenth_of_millimetre(double metres) { return std::round(1e4 * metres) / 1e4; }

Json points_json(const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2& p : points)
    list.push_back({tenth_of_millimetre(p.x()), tenth_of_millimetre(p.y())});
  return list;
}

/// Outline of every piece, edge by edge: what is sewn, what is hemmed.
Json panels_json(const pipeline::CaseGarment& garment) {
  const pattern::Pattern& pattern = garment.pattern.pattern;
  std::set<std::pair<int, int>> sewn;
  for (const pattern::Stitch& stitch : pattern.stitches)
    for (const pattern::Stitch::Side& side : {stitch.first, stitch.second})
      sewn.emplace(side.panel, side.edge);
  Json panels = Json::array();
  for (const std::string& name : garment.mesh().panel_names) {
    Json edges = Json::array();
    const int index = pattern.find_panel(name);
    for (int e = 0; index >= 0 && e < static_cast<int>(pattern.panels[index].edges.size()); ++e) {
      const pattern::Panel& panel = pattern.panels[index];
      const pattern::EdgePath path(panel, e);
      const int pieces =
          path.curves().size() == 1 && path.curves()[0].kind == pattern::EdgeCurve::Kind::line ? 1
                                                                                               : 24;
      std::vector<Vec2> points;
      for (int i = 0; i <= pieces; ++i) points.push_back(path.at(static_cast<double>(i) / pieces));
      edges.push_back({{"name", panel.edges[e].name},
                       {"sewn", sewn.count({index, e}) > 0},
                       {"points", points_json(points)}});
    }
    panels.push_back({{"name", spaced(name)}, {"id", name}, {"edges", edges}});
  }
  return panels;
}

std::vector<int> pairs(const std::vector<std::array<int, 2>>& lines) {
  std::vector<int> flat;
  for (const auto& line : lines) flat.insert(flat.end(), line.begin(), line.end());
  return flat;
}

/// Skin under every vertex in the reference state: place, region, anatomical address, contact.
Json partners_json(const pipeline::CaseResult& result, PackedArrays& arrays) {
  const pipeline::CaseMaps& maps = result.studied().maps;
  const placement::BodyAddresses addresses(result.body.body);
  std::vector<Vec3> points, percents;
  std::vector<int> regions, segments;
  std::vector<std::string> segment_names = {""};
  std::map<std::pair<int, int>, int> known;
  for (std::size_t v = 0; v < maps.worn.partners.size(); ++v) {
    points.push_back(maps.worn.partners[v].exact.point);
    regions.push_back(static_cast<int>(maps.worn.regions[v]));
    const auto address = addresses.address(maps.worn.partners[v].exact);
    percents.push_back(address ? address->percent : Vec3::Zero());
    int segment = 0;
    if (address) {
      const auto [at, is_new] =
          known.emplace(std::pair(static_cast<int>(address->segment), address->side),
                        static_cast<int>(segment_names.size()));
      if (is_new)
        segment_names.push_back((address->side > 0   ? "left "
                                 : address->side < 0 ? "right "
                                                     : "") +
                                spaced(placement::name(address->segment)));
      segment = at->second;
    }
    segments.push_back(segment);
  }
  Json names = Json::array();
  for (body::Region region : body::all_regions()) names.push_back(spaced(body::name(region)));
  Json all = {{"points", Json::parse(arrays.add_points(points))},
              {"region", Json::parse(arrays.add_counts(regions))},
              {"regions", names},
              {"segment", Json::parse(arrays.add_counts(segments))},
              {"segments", segment_names},
              {"percent", Json::parse(arrays.add_points(percents))}};
  return all;
}

Json touching_json(const maps::PressureField& field, PackedArrays& arrays) {
  if (field.empty()) return nullptr;
  return Json::parse(
      arrays.add_counts(std::vector<int>(field.touching.begin(), field.touching.end())));
}

Json garment_json(const pipeline::CaseResult& result, PackedArrays& arrays) {
  const garment::Garment& garment = result.studied().mesh();
  const Sheet sheet = make_sheet(garment);
  const render::GarmentLines lines = render::garment_lines(garment);
  Json all = {{"name", result.studied().pattern.pattern.name},
              {"vertices", garment.vertex_count},
              {"vertex", Json::parse(arrays.add_counts(sheet.vertex))},
              {"panel", Json::parse(arrays.add_counts(sheet.panel))},
              {"uv", Json::parse(arrays.add_points(sheet.uv))},
              {"triangles", Json::parse(arrays.add_counts(sheet.triangles, 3))},
              {"edges", Json::parse(arrays.add_counts(pairs(lines.boundary), 2))},
              {"seams", Json::parse(arrays.add_counts(pairs(lines.seams), 2))},
              {"panels", panels_json(result.studied())}};
  all["skin"] =
      result.studied().maps.worn.partners.empty() ? Json(nullptr) : partners_json(result, arrays);
  return all;
}

Json surface_json(const geometry::TriangleMesh& mesh, PackedArrays& arrays) {
  if (mesh.triangles.empty()) return nullptr;
  std::vector<int> corners;
  for (const Triangle& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  return {{"points", Json::parse(arrays.add_points(mesh.vertices))},
          {"triangles", Json::parse(arrays.add_counts(corners, 3))}};
}

Json values_json(const std::vector<pipeline::CaseMap>& maps, PackedArrays& arrays) {
  Json all = Json::object();
  for (const pipeline::CaseMap& entry : maps)
    all[entry.map.array] = {{"title", entry.map.title},
                            {"values", Json::parse(arrays.add_values(entry.map.values))},
                            {"min", entry.overall.min},
                            {"median", entry.overall.median},
                            {"max", entry.overall.max}};
  return all;
}

/// All maps of the reference posture and of the first donning. Of other postures of further
/// donnings slip alone: the page has to stay small.
std::vector<pipeline::CaseMap> shown_maps(const pipeline::CaseResult& result,
                                          const pipeline::CaseState* state) {
  if (!state) return result.studied().maps.maps;
  std::vector<pipeline::CaseMap> shown = state->maps.maps;
  if (!state->id.in_reference_posture() && !state->id.in_first_donning())
    std::erase_if(shown, [&](const pipeline::CaseMap& entry) {
      const maps::MapDefinition* slip = maps::find_map("slip");
      return std::none_of(slip->arrays.begin(), slip->arrays.end(), [&](const maps::MapArray& a) {
        return a.style.array == entry.map.array;
      });
    });
  return shown;
}

Json arrows_json(const pipeline::CaseResult& result, const pipeline::CaseState& state,
                 PackedArrays& arrays) {
  if (!state.counts() || state.id.in_reference_posture() || state.maps.worn.partners.empty())
    return nullptr;
  // Against the reference posture of the same donning.
  const std::vector<Vec3>* positions = &result.studied().drape.positions;
  const maps::WornGarment* worn = &result.studied().maps.worn;
  if (!state.id.in_first_donning()) {
    positions = nullptr;
    for (const pipeline::CaseState& other : result.wear.states)
      if (other.id == pipeline::StateId{pipeline::StateId::kReferencePosture, state.id.donning} &&
          other.counts()) {
        positions = &other.drape().positions;
        worn = &other.maps.worn;
      }
  }
  if (!positions || worn->partners.empty()) return nullptr;
  const body::PosedBody body = result.body_in(state.id.posture);
  const SlipArrows arrows =
      slip_arrows(result.studied().mesh(), {*positions, result.body.body, *worn},
                  {state.drape().positions, body, state.maps.worn});
  return {{"from", Json::parse(arrays.add_points(arrows.from))},
          {"to", Json::parse(arrays.add_points(arrows.to))}};
}

std::string posture_name(const pipeline::CaseResult& result, const pipeline::StateId& id) {
  return result.wear.postures.empty() ? "as worn" : result.wear.postures[id.posture];
}

/// The mannequin and what is worn over it under the studied garment.
Json body_json(const pipeline::CaseResult& result, const CaseForms& forms,
               const pipeline::CaseState* state, PackedArrays& arrays) {
  const geometry::TriangleMesh under = pipeline::surface_under_studied(result, state);
  return {{"form", surface_json(*forms.in_studied(state), arrays)},
          {"under", surface_json(under, arrays)}};
}

/// One mannequin per posture, that of its first drape, serves all donnings.
struct StateList {
  Json bodies = Json::array(), states = Json::array();
  std::map<int, int> body_of_posture;
};

void add_state(const pipeline::CaseResult& result, const CaseForms& forms,
               const pipeline::CaseState* state, PackedArrays& arrays, StateList& list) {
  const pipeline::StateId id = state ? state->id : pipeline::StateId{};
  const drape::Certificate certificate = state ? state->certificate() : result.certificate();
  // Garments under it move with every donning, so they need bodies of their own.
  const int key =
      result.worn_under().empty() ? id.posture : static_cast<int>(list.bodies.size()) + 1000;
  const auto [at, is_new] = list.body_of_posture.emplace(key, static_cast<int>(list.bodies.size()));
  if (is_new) list.bodies.push_back(body_json(result, forms, state, arrays));
  const maps::PressureField& pressure =
      state ? state->maps.pressure : result.studied().maps.pressure.field;
  const std::vector<Vec3>& positions =
      state ? state->drape().positions : result.studied().drape.positions;
  list.states.push_back({{"name", posture_name(result, id)},
                         {"posture", id.posture},
                         {"donning", id.donning},
                         {"holds", state ? state->counts() : certificate.holds()},
                         {"body", at->second},
                         {"positions", Json::parse(arrays.add_points(positions))},
                         {"touching", touching_json(pressure, arrays)},
                         {"maps", values_json(shown_maps(result, state), arrays)},
                         {"slip", state ? arrows_json(result, *state, arrays) : Json(nullptr)}});
}

/// `fitted`: the same array with the range that the colours have at first.
Json map_json(const maps::MapArrayStyle& style, const maps::MapArrayStyle& fitted) {
  Json all = {{"title", style.title},
              {"unit", style.percent ? "%" : style.unit},
              {"low", style.range_low},
              {"high", style.range_high},
              {"fitted", {fitted.range_low, fitted.range_high}},
              {"diverging", style.diverging},
              {"percent", style.percent},
              {"decimals", style.decimals},
              {"breaks", style.breaks},
              {"companion", style.companion},
              {"meaning", ""},
              {"formula", ""},
              {"source", ""}};
  if (const maps::MapArray* array = maps::find_map_array(style.array)) {
    all["meaning"] = array->meaning;
    all["formula"] = array->formula;
    all["source"] = array->source;
  }
  return all;
}

Json colours_json(const render::ColourTable& table) {
  return base64(std::string(reinterpret_cast<const char*>(table.data()), sizeof table));
}

}  // namespace

std::string scene_json(const pipeline::CaseResult& result, const CaseForms& forms,
                       PackedArrays& arrays) {
  Json scene = {{"garment", garment_json(result, arrays)}};
  StateList list;
  add_state(result, forms, nullptr, arrays, list);
  for (const pipeline::CaseState& state : result.wear.states)
    if (state.draped()) add_state(result, forms, &state, arrays, list);
  // Styles in the order of the report, those of other states after them.
  Json maps = Json::object(), order = Json::array();
  const std::vector<maps::MapArrayStyle> fitted = fitted_styles(result);
  const auto add_maps = [&](const std::vector<pipeline::CaseMap>& made) {
    for (const pipeline::CaseMap& entry : made) {
      if (maps.contains(entry.map.array)) continue;
      const auto own = std::find_if(fitted.begin(), fitted.end(), [&](const auto& style) {
        return style.array == entry.map.array;
      });
      maps[entry.map.array] = map_json(entry.map, *own);
      order.push_back(entry.map.array);
    }
  };
  add_maps(result.studied().maps.maps);
  for (const pipeline::CaseState& state : result.wear.states) add_maps(state.maps.maps);
  scene["maps"] = std::move(maps);
  scene["order"] = std::move(order);
  scene["states"] = std::move(list.states);
  scene["bodies"] = std::move(list.bodies);
  scene["colours"] = {{"sequential", colours_json(render::sequential_colours())},
                      {"diverging", colours_json(render::diverging_colours())}};
  return scene.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace loosefit::report
