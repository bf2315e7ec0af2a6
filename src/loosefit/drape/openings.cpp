#include "loosefit/drape/openings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "loosefit/base/check.h"
#include "loosefit/base/union_find.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/polyline.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/garment/flat_lengths.h"
#include "loosefit/geometry/box.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::drape {
namespace {

constexpr double kNeck = 0.88;    ///< of stature, above which nothing of a wearer begins
constexpr double kNear = 0.5;     ///< to a limb beside which a piece lies, arms raised or not [m]
constexpr double kAside = 0.04;   ///< from the middle of the body, beside it [m]
constexpr double kFoot = 0.12;    ///< height of a foot [m]
constexpr double kFace = 0.04;    ///< of stature, from the neck's joint up to the chin
constexpr double kNoHand = 0.08;  ///< girth that no hand goes through [m]
constexpr double kBeside = 0.1;   ///< of the garment's width: farther from its middle is beside it
constexpr double kOffCentre = 0.25;   ///< of an opening's own width, likewise
constexpr double kAlike = 0.25;       ///< relative difference of girth between two of a pair
constexpr double kWidestLimb = 0.67;  ///< of the widest cape's girth: wider tubes are for no limb
constexpr double kAtShoulder = 0.15;  ///< of the garment's height: an armhole ends so near its top
constexpr double kOpenFront = 0.6;    ///< of the garment's height, over which an open front runs
constexpr double kSlant = 0.1;        ///< of the garment's height, by which a hem may rise
constexpr double kUsualChest = 0.55;  ///< of the stature, where the body does not tell

struct Pair {
  int left, right;
};

/// Whether no vertex of the rim is on an edge of a piece.
bool is_cut_hole(const Opening& opening, const garment::Garment& garment) {
  return std::none_of(
      garment.edge_chains.begin(), garment.edge_chains.end(), [&](const auto& chain) {
        return std::find(chain.vertices.begin(), chain.vertices.end(), opening.loop.front()) !=
               chain.vertices.end();
      });
}

/// Whether two openings are as wide, as those of a pair are.
bool are_alike(const Opening& a, const Opening& b) {
  return std::abs(a.girth - b.girth) < kAlike * std::max(a.girth, b.girth);
}

/// Label that most vertices' pieces have.
std::string panel_label(const std::vector<int>& loop, const garment::Garment& garment,
                        const pattern::Pattern& pattern) {
  std::map<std::string, int> votes;
  for (int v : loop) {
    const int panel = pattern.find_panel(garment.panel_names[garment.vertex_panel[v]]);
    if (panel >= 0) ++votes[pattern.panels[panel].label];
  }
  const auto most = std::max_element(
      votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? std::string() : most->first;
}

/// Of every panel, whether its name says that it is a waistband.
std::vector<char> waistbands(const garment::Garment& garment) {
  std::vector<char> named;
  for (const std::string& name : garment.panel_names)
    named.push_back(pattern::words_of(name).waist);
  return named;
}

/// Whether all panels of each piece of cloth, by its number, are of legs, skirts or waistbands.
std::map<int, bool> pieces_of_legs(const std::vector<int>& piece, const garment::Garment& garment,
                                   const pattern::Pattern& pattern) {
  std::vector<char> legs;
  for (const std::string& name : garment.panel_names) {
    const int panel = pattern.find_panel(name);
    const pattern::PieceWords words = pattern::words_of(name);
    legs.push_back((panel >= 0 && pattern.panels[panel].label == "leg") || words.leg ||
                   words.skirt || words.waist);
  }
  std::map<int, bool> all;
  for (std::size_t v = 0; v < piece.size(); ++v) {
    bool& of = all.try_emplace(piece[v], true).first->second;
    of = of && legs[garment.vertex_panel[v]];
  }
  return all;
}

/// Tells what the openings `of` one piece of cloth are for.
class Uses {
 public:
  Uses(std::vector<Opening>& all, std::vector<int> of, const std::vector<Vec3>& placed,
       const geometry::Box3& box)
      : all_(all), of_(std::move(of)), placed_(placed), box_(box) {
    width_ = std::max(1e-9, box_.max().x() - box_.min().x());
    height_ = std::max(1e-9, box_.max().z() - box_.min().z());
    middle_ = 0.5 * (box_.min().x() + box_.max().x());
  }

  void tell(const std::vector<std::string>& labels) {
    sort_out();
    const std::size_t middles = middle_ones_.size(), pairs = pairs_.size();
    if (middles == 2 && pairs == 0 && !open_front_ && of_.size() == 2) {
      int top = middle_ones_[0], bottom = middle_ones_[1];
      if (!is_upper_end(all_[top], all_[bottom])) std::swap(top, bottom);
      use(top, at_waist(top) ? kinds::OpeningUse::waist : kinds::OpeningUse::upper);
      use(bottom, kinds::OpeningUse::hem);
    } else if (middles == 0 && pairs == 0 && of_.size() == 2) {
      for (int i : of_) use(i, kinds::OpeningUse::limb);
    } else if (of_legs() && middles == 2 && (of_.size() == 3 || pairs == 1)) {
      // A skirt with slits for pockets, or trousers whose fly is open.
      use(middle_ones_[0],
          at_waist(middle_ones_[0]) ? kinds::OpeningUse::waist : kinds::OpeningUse::upper);
      if (pairs == 1 && height_of(pairs_[0]) < all_[middle_ones_[1]].placed.z())
        legs(pairs_[0]);
      else
        use(middle_ones_[1], kinds::OpeningUse::hem);
    } else if (middles == 2 && pairs == 1 && of_.size() == 4) {
      use(middle_ones_[0], kinds::OpeningUse::neck);
      use(middle_ones_[1], kinds::OpeningUse::hem);
      arms(pairs_[0]);
    } else if (middles == 1 && pairs == 1 && of_.size() == 3) {
      const bool below = height_of(pairs_[0]) < all_[middle_ones_[0]].placed.z();
      if (below && labels[pairs_[0].left] != "arm") {
        use(middle_ones_[0], kinds::OpeningUse::waist);
        legs(pairs_[0]);
      }
    } else if (of_legs() && middles == 1 && pairs == 2 && of_.size() == 5) {
      use(middle_ones_[0], kinds::OpeningUse::waist);
      legs(pairs_[1]);
    } else if (middles == 1 && pairs == 2 && of_.size() == 5) {
      use(middle_ones_[0], kinds::OpeningUse::neck);
      arms(pairs_[0]);
      legs(pairs_[1]);
    } else if (open_front_ && pairs == 1 && middles == 0) {
      arms(pairs_[0]);
    } else if (const int armhole = single_armhole(labels); armhole >= 0) {
      use(armhole,
          beside(armhole) > 0 ? kinds::OpeningUse::left_arm : kinds::OpeningUse::right_arm);
      use(middle_ones_.back(), kinds::OpeningUse::hem);
    }
    for (const Pair& pair : pairs_) {  // whatever the rest is
      if (labels[pair.left] == "arm") arms(pair);
      if (labels[pair.left] == "leg") legs(pair);
    }
  }

 private:
  /// Of a garment that hangs on one shoulder: three openings, the lowest in the middle; of the
  /// others the armhole is the smaller one, lies beside the middle and comes up to the shoulder.
  /// The neck and the other arm go through the third, which comes down beside the armhole, as no
  /// waist over the slit of a pocket does. −1: it is none.
  int single_armhole(const std::vector<std::string>& labels) const {
    if (of_.size() != 3 || !pairs_.empty() || middle_ones_.empty() || of_legs()) return -1;
    const int hem = middle_ones_.back();
    std::vector<int> upper;
    for (int i : of_)
      if (i != hem) upper.push_back(i);
    if (upper.size() != 2) return -1;
    if (all_[upper[0]].girth > all_[upper[1]].girth) std::swap(upper[0], upper[1]);
    const int armhole = upper[0];
    double highest = box_.min().z(), lowest_of_neck = box_.max().z();
    for (int v : all_[armhole].loop) highest = std::max(highest, placed_[v].z());
    for (int v : all_[upper[1]].loop) lowest_of_neck = std::min(lowest_of_neck, placed_[v].z());
    const bool above = std::min(all_[upper[0]].placed.z(), all_[upper[1]].placed.z()) >
                       all_[hem].placed.z() + 0.5 * height_;
    return above && lowest_of_neck < all_[armhole].placed.z() && side_of(armhole) != 0 &&
                   labels[armhole] != "leg" && highest > box_.max().z() - kAtShoulder * height_
               ? armhole
               : -1;
  }

  void use(int opening, kinds::OpeningUse what) { all_[opening].use = what; }
  void arms(const Pair& p) {
    use(p.left, kinds::OpeningUse::left_arm), use(p.right, kinds::OpeningUse::right_arm);
  }
  void legs(const Pair& p) {
    use(p.left, kinds::OpeningUse::left_leg), use(p.right, kinds::OpeningUse::right_leg);
  }
  bool of_legs() const { return all_[of_.front()].of_legs; }
  bool at_waist(int opening) const { return all_[opening].at_waist; }
  double beside(int opening) const { return all_[opening].placed.x() - middle_; }
  double height_of(const Pair& p) const {
    return 0.5 * (all_[p.left].placed.z() + all_[p.right].placed.z());
  }

  /// +1 or −1 where the rim lies beside the middle, left or right.
  int side_of(int i) const {
    double low = box_.max().x(), high = box_.min().x();
    for (int v : all_[i].loop) {
      low = std::min(low, placed_[v].x());
      high = std::max(high, placed_[v].x());
    }
    // A leg's opening lies near the middle of a wide garment, but far from it for its own width.
    const double limit = std::min(kBeside * width_, kOffCentre * (high - low));
    return beside(i) > limit ? 1 : beside(i) < -limit ? -1 : 0;
  }

  /// The heights between which a rim runs.
  std::pair<double, double> heights_of(const Opening& opening) const {
    double low = box_.max().z(), high = box_.min().z();
    for (int v : opening.loop) {
      low = std::min(low, placed_[v].z());
      high = std::max(high, placed_[v].z());
    }
    return {low, high};
  }

  /// Neck, edges of the front and hem in one rim. A hem of its own below it tells a deep neck, as
  /// one between straps is.
  bool is_front_rim(int i) const {
    const auto [low, high] = heights_of(all_[i]);
    const bool hem_below = std::any_of(of_.begin(), of_.end(), [&, low = low](int j) {
      return j != i && side_of(j) == 0 && all_[j].girth > kNoHand &&
             heights_of(all_[j]).second < low + kSlant * height_;
    });
    return high - low > kOpenFront * height_ && !hem_below;
  }

  void sort_out() {
    std::vector<int> left, right;
    for (int i : of_) {
      if (const int side = side_of(i); side != 0)
        (side > 0 ? left : right).push_back(i);
      else if (of_.size() > 2 && is_front_rim(i))
        open_front_ = true;
      else
        middle_ones_.push_back(i);
    }
    const double near = kBeside * std::max(width_, height_);
    for (int l : left)
      for (int r : right) {
        const Opening &a = all_[l], &b = all_[r];
        if (std::abs(beside(l) + beside(r)) < near &&
            std::abs(a.placed.z() - b.placed.z()) < near && are_alike(a, b))
          pairs_.push_back({l, r});
      }
    const auto higher = [this](int a, int b) { return all_[a].placed.z() > all_[b].placed.z(); };
    std::stable_sort(middle_ones_.begin(), middle_ones_.end(), higher);
    std::stable_sort(pairs_.begin(), pairs_.end(),
                     [this](const Pair& a, const Pair& b) { return height_of(a) > height_of(b); });
  }

  std::vector<Opening>& all_;
  std::vector<int> of_;
  const std::vector<Vec3>& placed_;
  geometry::Box3 box_;
  double width_ = 1, height_ = 1, middle_ = 0;
  std::vector<int> middle_ones_;  ///< the highest first
  std::vector<Pair> pairs_;       ///< the highest first
  bool open_front_ = false;
};

/// Drops holes of unknown use that no hand goes through, but for cuffs: of a piece of cloth just
/// two that are alike, beside the middle, left and right, at edges of pieces for arms or legs.
void drop_small(std::vector<Opening>& openings, const garment::Garment& garment,
                const pattern::Pattern& pattern) {
  std::map<int, std::vector<const Opening*>> cuffs;  // by piece of cloth
  double sum = 0;
  for (const Opening& o : openings) {
    sum += o.placed.x();
    const std::string label = panel_label(o.loop, garment, pattern);
    if (!o.is_cut_hole && o.girth < kNoHand && (label == "arm" || label == "leg"))
      cuffs[o.piece].push_back(&o);
  }
  const double middle = sum / std::max<double>(1, static_cast<double>(openings.size()));
  std::set<int> kept;  // first vertices
  for (const auto& [piece, of] : cuffs)
    if (of.size() == 2 && are_alike(*of[0], *of[1]) &&
        (of[0]->placed.x() - middle) * (of[1]->placed.x() - middle) < 0)
      for (const Opening* o : of) kept.insert(o->loop.front());
  std::erase_if(openings, [&](const Opening& o) {
    return o.use == kinds::OpeningUse::unknown && o.girth < kNoHand &&
           !kept.contains(o.loop.front());
  });
}

/// Tells by the kind of the garment what its openings are for; false where it does not know.
bool tell_by_kind(std::vector<Opening>& openings, const garment::Garment& garment,
                  const pattern::Pattern& pattern) {
  const std::vector<kinds::KindOpening>& made = kinds::garment_kind(pattern.kind).openings;
  for (const kinds::KindOpening& known : made) {
    std::set<int> rim;
    for (const auto& [panel, edge] : known.edges)
      if (const auto* chain = garment.find_part(panel, edge))
        rim.insert(chain->vertices.begin(), chain->vertices.end());
    for (Opening& opening : openings)
      if (std::all_of(opening.loop.begin(), opening.loop.end(),
                      [&](int v) { return rim.count(v) > 0; }))
        opening.use = known.use;
  }
  return !made.empty();
}

/// Tells by the lines of a wearer in rest posture what pieces with one or two openings are for.
class ByWearer {
 public:
  ByWearer(const garment::Garment& garment, const pattern::Pattern& pattern,
           const std::vector<Vec3>& placed, const body::PosedBody& body)
      : garment_(garment), pattern_(pattern), placed_(placed), piece_(pieces_of_cloth(garment)) {
    const RestLevels levels(body);
    height_ = levels.height;
    joints_ = levels.joints();
    lines_ = limb_lines(joints_);
    cape_ = kForTheWaist * chest_girth(body, levels);
  }

  /// A cut hole is for nothing unless the edges do not say without it what they are for. A single
  /// edge that fits a limb says that by itself, a wider one is that of a poncho round its neck.
  void tell_with_holes(const std::vector<Opening*>& of) const {
    std::vector<Opening*> edges;
    std::ranges::copy_if(of, std::back_inserter(edges),
                         [](const Opening* o) { return !o->is_cut_hole; });
    const bool for_nothing = std::ranges::all_of(of, [](const Opening* o) {
      return !o->is_cut_hole || o->use == kinds::OpeningUse::unknown;
    });
    if (edges.empty() || edges.size() == of.size()) return tell(of);
    if (for_nothing) return tell(edges);
    if (edges.size() > 1 || edges[0]->girth > cape_) return tell(of);
    std::vector<kinds::OpeningUse> uses;
    for (Opening* o : of) uses.push_back(std::exchange(o->use, kinds::OpeningUse::unknown));
    tell(edges);
    if (edges[0]->use != kinds::OpeningUse::unknown) return;
    for (std::size_t i = 0; i < of.size(); ++i) of[i]->use = uses[i];
    tell(of);
  }

 private:
  void tell(std::vector<Opening*> of) const {
    const auto labelled = [](const Opening* o) { return o->at_waist || o->at_chest; };
    if (lines_[kHead].empty() || of.size() > 2 || std::ranges::any_of(of, labelled)) return;
    if (of.size() == 2 && !is_upper_end(*of[0], *of[1])) std::swap(of[0], of[1]);
    LimbNumbers round = limbs_through_openings(of[0]->loop, placed_, lines_);
    double share = 1;  // of the heights
    if (of.size() == 2 && round == kRoundNothing) {
      round = as_if_smaller(*of[0]);
      if (round != kRoundNothing) share = share_as_if_smaller();
    }
    if (of.size() == 2)
      tell_tube(*of[0], *of[1], round, share);
    else if (is_one_limb(round) && of[0]->use == kinds::OpeningUse::unknown)
      for_limb(of, round, true);
    const bool told = std::ranges::any_of(of, [](const Opening* o) {
      return o->use != kinds::OpeningUse::tube && o->use != kinds::OpeningUse::unknown;
    });
    if (told || round != kRoundNothing) return;
    const int limb = limb_beside(of.front()->piece);
    const double widest = limb == kHead ? cape_ : kWidestLimb * cape_;
    const auto fits = [&](const Opening* o) { return o->girth <= widest; };
    if (limb != kLimbs && std::ranges::all_of(of, fits))
      for_limb(of, round_limb(Limb(limb)), false);
  }

  /// Of the heights of a pattern that begins above this neck, to begin there.
  double share_as_if_smaller() const {
    double top = 0;
    for (const Vec3& p : placed_) top = std::max(top, p.z());
    return kNeck * height_ / std::max(1e-9, top);
  }

  /// The same of a cape that was placed for somebody so tall that it begins above this neck.
  LimbNumbers as_if_smaller(const Opening& upper) const {
    const double share = share_as_if_smaller();
    if (!(share < 1)) return kRoundNothing;
    std::vector<Vec3> smaller = placed_;
    for (int v : upper.loop) smaller[v].z() *= share;
    const LimbNumbers round = limbs_through_openings(upper.loop, smaller, lines_);
    return round == kRoundNeck ? round : kRoundNothing;
  }

  static bool is_one_limb(const LimbNumbers& round) {
    return std::ranges::count(round, 0) == kLimbs - 1;
  }

  static void for_limb(const std::vector<Opening*>& of, const LimbNumbers& round, bool as_placed) {
    for (Opening* o : of)
      o->use = kinds::OpeningUse::limb, o->round = round, o->placed_round = as_placed;
  }

  bool is_above_neck(const Vec3& p) const {
    return p.z() > joints_.at("neck").z() + kFace * height_;
  }

  void tell_tube(Opening& upper, Opening& lower, const LimbNumbers& round, double share) const {
    const Vec3& at = lower.placed;
    const bool above_neck = is_above_neck(Vec3(at.x(), at.y(), share * at.z()));
    if (round == kRoundTrunk || (round == kRoundNeck && upper.of_legs)) {
      upper.use = kinds::OpeningUse::upper, lower.use = kinds::OpeningUse::hem;
    } else if (round == kRoundNeck && upper.girth < cape_ && !above_neck) {
      upper.use = kinds::OpeningUse::neck, lower.use = kinds::OpeningUse::cape_hem;
    } else if (is_one_limb(round) && (round != kRoundNeck || above_neck) &&
               upper.girth < kWidestLimb * cape_) {
      for_limb({&upper, &lower}, round, true);
    } else {
      upper.use = lower.use = kinds::OpeningUse::tube;
    }
  }

  /// The limb beside which a piece lies that goes round none as it is placed: that of somebody who
  /// holds it otherwise, or a strip that is not yet sewn to a ring; kLimbs: none.
  int limb_beside(int piece) const {
    Vec3 sum = Vec3::Zero();
    int count = 0, arm = 0, leg = 0;
    for (int v = 0; v < garment_.vertex_count; ++v) {
      if (piece_[v] != piece) continue;
      sum += placed_[v], ++count;
      const int panel = pattern_.find_panel(garment_.panel_names[garment_.vertex_panel[v]]);
      if (panel < 0) continue;
      arm += pattern_.panels[panel].label == "arm", leg += pattern_.panels[panel].label == "leg";
    }
    const Vec3 centre = sum / count;
    const double aside = centre.x() - joints_.at("neck").x();
    if (arm + leg == 0 && is_above_neck(centre) && std::abs(aside) < kAside) return kHead;
    if (std::abs(aside) < kAside) return kLimbs;
    const int side = aside > 0 ? 1 : -1;
    const Limb of_arm = side > 0 ? kLeftArm : kRightArm, of_leg = side > 0 ? kLeftLeg : kRightLeg;
    const auto away = [&](Limb limb) {
      const Polyline line({lines_[limb].begin() + 1, lines_[limb].end()});
      return (line.at(std::max(0.0, line.project(centre))).point - centre).norm();
    };
    const Limb limb = arm != leg ? (arm > leg ? of_arm : of_leg)
                                 : (away(of_arm) < away(of_leg) ? of_arm : of_leg);
    return away(limb) < kNear ? limb : kLimbs;
  }

  const garment::Garment& garment_;
  const pattern::Pattern& pattern_;
  const std::vector<Vec3>& placed_;
  std::vector<int> piece_;
  std::map<std::string, Vec3> joints_;
  LimbLines lines_;
  double height_ = 0;  ///< stature [m]
  double cape_ = 0;    ///< widest girth of the neck of a cape [m]
};

}  // namespace

std::vector<Opening> garment_openings(const garment::Garment& garment,
                                      const pattern::Pattern& pattern,
                                      const body::PosedBody& body) {
  std::vector<Opening> openings = garment_openings(garment, pattern);
  const std::vector<Vec3> placed = placed_by_pattern(garment, pattern);
  if (placed.empty() || limb_lines(body.body())[kHead].empty()) return openings;
  const ByWearer wearer(garment, pattern, placed, body);
  std::map<int, std::vector<Opening*>> of_piece;
  for (Opening& o : openings) of_piece[o.piece].push_back(&o);
  for (auto& [piece, of] : of_piece) wearer.tell_with_holes(of);
  return openings;
}

bool is_upper_end(const Opening& a, const Opening& b) {
  return a.is_named_top() != b.is_named_top() ? a.is_named_top() : a.placed.z() >= b.placed.z();
}

std::vector<Vec3> placed_by_pattern(const garment::Garment& garment,
                                    const pattern::Pattern& pattern) {
  std::vector<Vec3> sum(garment.vertex_count, Vec3::Zero());
  std::vector<int> count(garment.vertex_count, 0);
  std::set<std::pair<int, int>> seen;  // (vertex, panel)
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int k = garment.triangle_panel[t];
    const int found = pattern.find_panel(garment.panel_names[k]);
    if (found < 0) return {};
    const pattern::Panel& panel = pattern.panels[found];
    for (int c = 0; c < 3; ++c) {
      const int v = garment.triangles[t][c];
      if (!seen.emplace(v, k).second) continue;
      const Vec2& uv = garment.triangle_uv[t][c];
      sum[v] += panel.rotation * Vec3(uv.x(), uv.y(), 0) + panel.translation;
      ++count[v];
    }
  }
  for (int v = 0; v < garment.vertex_count; ++v) sum[v] /= std::max(1, count[v]);
  return sum;
}

std::vector<int> labelled_vertices(const garment::Garment& garment, const pattern::Pattern& pattern,
                                   const std::string& label) {
  std::set<int> found;
  for (const garment::Garment::EdgeChain& chain : garment.edge_chains) {
    const int panel = pattern.find_panel(garment.panel_names[chain.panel]);
    if (panel < 0 || chain.edge >= static_cast<int>(pattern.panels[panel].edges.size())) continue;
    if (pattern.panels[panel].edges[chain.edge].label == label)
      found.insert(chain.vertices.begin(), chain.vertices.end());
  }
  return {found.begin(), found.end()};
}

std::vector<Opening> garment_openings(const garment::Garment& garment,
                                      const pattern::Pattern& pattern) {
  const std::vector<Vec3> placed = placed_by_pattern(garment, pattern);
  const geometry::MeshTopology topology(garment.triangles);
  const std::vector<double> lengths = garment::flat_lengths(garment, topology);
  const std::vector<int> piece = pieces_of_cloth(garment);
  const std::map<int, bool> of_legs = pieces_of_legs(piece, garment, pattern);
  const std::vector<int> waist = labelled_vertices(garment, pattern, "lower_interface"),
                         chest = labelled_vertices(garment, pattern, "strapless_top");
  const std::vector<char> bands = waistbands(garment);
  std::vector<Opening> openings;
  for (std::vector<int>& loop : topology.boundary_loops()) {
    Opening opening;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int edge = topology.find(loop[i], loop[(i + 1) % loop.size()]);
      require(edge >= 0, "the rim of an opening runs along edges of the garment");
      opening.girth += lengths[edge];
      if (!placed.empty()) opening.placed += placed[loop[i]] / static_cast<double>(loop.size());
    }
    // Half of the rim: a label also marks the ends of its neighbours.
    const auto on = [&loop](const std::vector<int>& marked) {
      const auto hits = std::count_if(loop.begin(), loop.end(), [&](int v) {
        return std::binary_search(marked.begin(), marked.end(), v);
      });
      return 2 * static_cast<std::size_t>(hits) > loop.size();
    };
    opening.at_waist = on(waist);
    opening.at_chest = on(chest);
    opening.piece = piece[loop.front()];
    opening.of_legs = of_legs.at(opening.piece);
    // The band at the hem of a top may be called so as well.
    opening.of_waistband = opening.of_legs && std::all_of(loop.begin(), loop.end(), [&](int v) {
                             return bands[garment.vertex_panel[v]] != 0;
                           });
    opening.loop = std::move(loop);
    opening.is_cut_hole = is_cut_hole(opening, garment);
    openings.push_back(std::move(opening));
  }
  const bool by_kind = !placed.empty() && tell_by_kind(openings, garment, pattern);
  drop_small(openings, garment, pattern);
  if (placed.empty() || by_kind) return openings;
  geometry::Box3 box;
  for (const Vec3& p : placed) box.extend(p);
  std::vector<std::string> labels;
  std::map<int, std::vector<int>> of_piece;
  for (const Opening& o : openings) {
    of_piece[o.piece].push_back(static_cast<int>(labels.size()));
    labels.push_back(panel_label(o.loop, garment, pattern));
  }
  for (const auto& [root, of] : of_piece) {
    // A hole cut into a piece is for nothing where the other openings say what they are for without
    // it; else it may be the neck.
    std::vector<int> of_edges;
    std::copy_if(of.begin(), of.end(), std::back_inserter(of_edges),
                 [&](int i) { return !openings[i].is_cut_hole; });
    if (!of_edges.empty()) Uses(openings, of_edges, placed, box).tell(labels);
    const bool told = std::any_of(
        of.begin(), of.end(), [&](int i) { return openings[i].use != kinds::OpeningUse::unknown; });
    if (!told && of_edges.size() < of.size()) Uses(openings, of, placed, box).tell(labels);
  }
  return openings;
}

double chest_girth(const body::Body& body, const RestLevels& levels) {
  const auto chest = body.measured.find("chest");
  return chest != body.measured.end() ? chest->second : kUsualChest * levels.height;
}

std::vector<int> pieces_of_cloth(const garment::Garment& garment) {
  UnionFind sets(garment.vertex_count);
  for (const Triangle& t : garment.triangles)
    for (int k = 1; k < 3; ++k) sets.unite(t[0], t[k]);
  std::vector<int> of(garment.vertex_count);
  for (int v = 0; v < garment.vertex_count; ++v) of[v] = sets.find(v);
  return of;
}

bool goes_under_soles(const garment::Garment& garment, const pattern::Pattern& pattern,
                      const std::vector<Opening>& openings) {
  const std::vector<Vec3> placed = placed_by_pattern(garment, pattern);
  if (placed.empty()) return false;
  const std::vector<int> piece = pieces_of_cloth(garment);
  std::map<int, std::vector<const Opening*>> edges;
  for (const Opening& o : openings)
    if (!o.is_cut_hole) edges[o.piece].push_back(&o);
  return std::ranges::any_of(edges, [&](const auto& of) {
    const LimbNumbers& round = of.second.front()->round;
    if (round != kRoundNothing)
      return of.second.size() == 1 &&
             (round == round_limb(kLeftLeg) || round == round_limb(kRightLeg));
    double lowest = HUGE_VAL, lowest_edge = HUGE_VAL;
    for (int v = 0; v < garment.vertex_count; ++v)
      if (piece[v] == of.first) lowest = std::min(lowest, placed[v].z());
    for (const Opening* o : of.second)
      for (int v : o->loop) lowest_edge = std::min(lowest_edge, placed[v].z());
    return lowest < kFoot && lowest_edge - lowest > kFoot;
  });
}

bool is_open_front(const Opening& edge, const std::vector<Opening>& all) {
  using kinds::OpeningUse;
  if (edge.use != OpeningUse::unknown) return false;
  const auto any_of_its_cloth = [&](const auto& what) {
    return std::ranges::any_of(all,
                               [&](const Opening& o) { return o.piece == edge.piece && what(o); });
  };
  return any_of_its_cloth([](const Opening& o) {
           return o.use == OpeningUse::left_arm || o.use == OpeningUse::right_arm;
         }) &&
         !any_of_its_cloth([&](const Opening& o) {
           return o.use == OpeningUse::neck ||
                  (o.use == OpeningUse::unknown && o.girth > edge.girth);
         });
}

}  // namespace loosefit::drape
