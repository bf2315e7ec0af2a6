#include "loosefit/drape/explain_unsettled.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/geometry/folded_edges.h"

namespace loosefit::drape {
namespace {

constexpr double kMost = 0.9;  ///< share of ‖F‖² that counts as most of it
constexpr std::size_t kWorst = 10, kCuts = 20;
constexpr std::size_t kGroups = 3;  ///< of cuts that the one line names

std::string part_name(const body::Body& body, int skin_vertex) {
  static constexpr std::array kNames = {"head", "neck",  "torso", "upper arm", "forearm",
                                        "hand", "thigh", "shank", "foot"};
  if (body.segment.empty()) return "body";
  const std::string name = kNames[static_cast<std::size_t>(body.segment[skin_vertex])];
  const int side = body.side.empty() ? 0 : body.side[skin_vertex];
  const bool limb = body.segment[skin_vertex] >= body::Segment::upper_arm;
  if (!limb || side == 0) return name;
  return (side > 0 ? "left " : "right ") + name;
}

std::string nearest_part(const body::PosedBody& body, const Vec3& p) {
  return part_name(body, body->surface.triangles[body.tree().query(p).triangle][0]);
}

/// The garments of a model and the places in them.
struct Wardrobe {
  const ClothMesh& mesh;
  const std::vector<const garment::Garment*>& layers;

  int layer_of_vertex(int v) const {
    return static_cast<int>(
               std::upper_bound(mesh.first_vertex.begin(), mesh.first_vertex.end(), v) -
               mesh.first_vertex.begin()) -
           1;
  }
  std::string panel_name(int layer, int panel) const {
    const std::string& name = layers[layer]->panel_names[panel];
    return layers.size() > 1 ? fmt::format("{} of garment {}", name, layer + 1) : name;
  }
  std::string panel_of_triangle(int t) const {
    const int l = mesh.triangle_layer[t];
    return panel_name(l, layers[l]->triangle_panel[t - mesh.first_triangle[l]]);
  }
};

CutTriangle cut_triangle(const Wardrobe& w, const std::vector<Vec3>& x, int t) {
  const int l = w.mesh.triangle_layer[t];
  CutTriangle cut;
  cut.triangle = t - w.mesh.first_triangle[l];
  cut.panel = w.panel_of_triangle(t);
  for (int k = 0; k < 3; ++k) {
    cut.at += w.layers[l]->triangle_uv[cut.triangle][k] / 3;
    cut.position += x[w.mesh.triangles[t][k]] / 3;
  }
  return cut;
}

/// Every triangle that cuts something, once for each thing that it cuts. `below`: the floor.
std::vector<CutTriangle> all_cuts(const Wardrobe& w, const std::vector<Vec3>& x,
                                  const body::PosedBody& body, const std::vector<int>& below) {
  std::vector<CutTriangle> cuts;
  std::map<std::pair<int, std::string>, bool> seen;
  const auto add = [&](int t, const std::string& with) -> CutTriangle* {
    if (!seen.emplace(std::pair(t, with), true).second) return nullptr;
    cuts.push_back(cut_triangle(w, x, t));
    cuts.back().with = with;
    return &cuts.back();
  };
  const geometry::TriangleMesh& skin = body->surface;
  const auto& triangles = w.mesh.triangles;
  for (const auto& [t, s] : geometry::mesh_intersections(x, triangles, body.tree())) {
    const int skin_vertex = skin.triangles[s][0];
    CutTriangle* cut = add(t, part_name(body, skin_vertex));
    if (!cut) continue;
    cut->body = true;
    if (!body->segment.empty()) cut->segment = body->segment[skin_vertex];
  }
  for (int t : below)
    if (CutTriangle* cut = add(t, "floor")) cut->body = true;
  for (const auto& [t, s] : geometry::self_intersections(x, triangles))
    add(t, w.panel_of_triangle(s));
  for (const auto& [t, s] : geometry::folded_edges(x, triangles)) add(t, w.panel_of_triangle(s));
  return cuts;
}

std::string cuts_in_words(const std::vector<CutTriangle>& cuts, bool of_body) {
  std::map<std::string, int> count;
  int all = 0;
  for (const CutTriangle& c : cuts)
    if (c.body == of_body) ++all, ++count[c.panel + (of_body ? " the " : " ") + c.with];
  if (all == 0) return {};
  std::vector<std::pair<std::string, int>> groups(count.begin(), count.end());
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text = fmt::format("{} triangle{} cut{} the {}: ", all, all == 1 ? "" : "s",
                                 all == 1 ? "s" : "", of_body ? "body" : "cloth itself");
  for (std::size_t i = 0; i < std::min(groups.size(), kGroups); ++i)
    text += fmt::format("{}{} ({})", i ? ", " : "", groups[i].first, groups[i].second);
  return text + (groups.size() > kGroups ? ", …" : "");
}

std::string balance_in_words(const Unsettled& u) {
  const UnbalancedVertex& v = u.worst.front();
  std::array<int, kForceNames.size()> order;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return v.force[a] > v.force[b]; });
  std::string text = fmt::format("the net force is {:.3g} times what is allowed", u.times_allowed);
  if (u.lagging_share > 0.5) return text + ", most of it friction that does not come to rest";
  return text + fmt::format(
                    "; {} {} 90 % of it, the worst in {} at ({:.3f}, {:.3f}) m near the {}: {:.2g} "
                    "N left of {} {:.2g} N and {} {:.2g} N",
                    u.vertices_of_most, u.vertices_of_most == 1 ? "vertex bears" : "vertices bear",
                    v.panel, v.at.x(), v.at.y(), v.near, v.net, kForceNames[order[0]],
                    v.force[order[0]], kForceNames[order[1]], v.force[order[1]]);
}

}  // namespace

Unsettled explain_unsettled(ClothModel& model, const std::vector<const garment::Garment*>& layers,
                            const std::vector<Vec3>& x, const body::PosedBody& body,
                            const Certificate& certificate) {
  Unsettled u;
  const Wardrobe wardrobe{model.mesh(), layers};
  const ClothModel::Forces forces = model.forces(x);
  std::vector<double> square(x.size());
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Vec3 net = Vec3::Zero();
    for (const particles::VectorField& f : forces) net += f[i];
    square[i] = net.squaredNorm();
    sum += square[i];
  }
  const double lag = std::pow(model.system().lagged_friction_force(), 2);
  u.lagging_share = sum + lag > 0 ? lag / (sum + lag) : 0;
  u.times_allowed = certificate.residual / certificate.allowed_residual;
  if (u.times_allowed <= 1)  // then it is one particle alone
    u.times_allowed =
        std::max(u.times_allowed, certificate.residual_max / certificate.allowed_largest());
  std::vector<int> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return square[a] > square[b]; });
  for (double part = 0; u.vertices_of_most < static_cast<int>(order.size()) && part < kMost * sum;)
    part += square[order[u.vertices_of_most++]];
  for (std::size_t k = 0; k < std::min(kWorst, order.size()); ++k) {
    const int i = order[k];
    UnbalancedVertex v;
    const int layer = wardrobe.layer_of_vertex(i);
    v.vertex = i - wardrobe.mesh.first_vertex[layer];
    v.panel = wardrobe.panel_name(layer, layers[layer]->vertex_panel[v.vertex]);
    v.at = layers[layer]->vertex_uv[v.vertex];
    v.position = x[i];
    v.near = nearest_part(body, x[i]);
    v.net = std::sqrt(square[i]);
    for (std::size_t f = 0; f < forces.size(); ++f) v.force[f] = forces[f][i].norm();
    u.worst.push_back(std::move(v));
  }
  u.cuts = all_cuts(wardrobe, x, body, model.below_floor(x));
  if (!certificate.is_balanced() && !u.worst.empty()) u.why = balance_in_words(u);
  for (bool of_body : {true, false}) {
    const std::string text = cuts_in_words(u.cuts, of_body);
    if (!text.empty()) u.why += (u.why.empty() ? "" : "; ") + text;
  }
  u.cuts.resize(std::min(kCuts, u.cuts.size()));
  return u;
}

}  // namespace loosefit::drape
