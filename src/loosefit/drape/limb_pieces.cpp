#include "loosefit/drape/limb_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/drape/clear_panel.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/drape/rolled_panel.h"
#include "loosefit/geometry/box.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/rotation_between.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::drape {
namespace {

constexpr double kAgrees = 0.03;       ///< a placement so near is kept [m]
constexpr double kAtEnd = 0.01;        ///< of a closed end from the end of its limb [m]
constexpr double kClear = 0.01;        ///< of a panel from its limb [m]
constexpr double kSlit = radians(60);  ///< between the sides of a slit that parts two fingers
constexpr int kSlits = 2;              ///< of a glove with fingers

/// Where limbs begin in their lines: the arm at the shoulder, the leg at the hip, the head at the
/// neck.
Polyline line_of(const LimbLines& lines, Limb limb) {
  const std::ptrdiff_t first = limb == kLeftLeg || limb == kRightLeg ? 2 : 1;
  return Polyline({lines[limb].begin() + first, lines[limb].end()});
}

bool is_arm(Limb limb) { return limb == kLeftArm || limb == kRightArm; }

/// Slits in an outline: corners at which it turns back into itself.
int slits(const pattern::Panel& panel) {
  const std::vector<Vec2> outline = pattern::outline_polygon(panel);
  const std::size_t n = outline.size();
  int count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = outline[i] - outline[(i + n - 1) % n], out = outline[(i + 1) % n] - outline[i];
    const double turn = std::atan2(geometry::cross(in, out), in.dot(out));
    count += turn < kSlit - kPi;
  }
  return count;
}

void refuse_fingers(const pattern::Panel& panel) {
  if (slits(panel) < kSlits) return;
  throw GeometryError({{}, 0, "pattern: panel " + panel.name}, "a glove with fingers",
                      "what goes over a hand as a whole, for there is no place for gloves: contact "
                      "takes each hand as a closed shape without gaps between its fingers",
                      "drape a mitten or a cuff, or take the panel out of the file");
}

}  // namespace

LimbPieces::LimbPieces(const garment::Garment& sewn, const garment::OpenSeams& open,
                       const std::vector<Opening>& openings, const body::PosedBody& body)
    : open_(open),
      body_(body),
      at_rest_(limb_lines(RestLevels(body).joints())),
      worn_(limb_lines(body.body())),
      of_panel_(open.garment.panel_names.size(), -1) {
  std::map<int, std::vector<const Opening*>> of_piece;
  for (const Opening& o : openings)
    if (o.use == kinds::OpeningUse::limb) of_piece[o.piece].push_back(&o);
  if (of_piece.empty()) return;
  const std::vector<int> cloth = pieces_of_cloth(sewn);
  for (const auto& [root, of] : of_piece) {
    const auto limb = std::ranges::find_if(of[0]->round, [](int n) { return n != 0; });
    if (limb == of[0]->round.end()) continue;
    const bool first = of.size() < 2 || is_upper_end(*of[0], *of[1]);
    const Opening &upper = *of[first ? 0 : 1], &lower = *of[first ? of.size() - 1 : 0];
    Piece piece{Limb(limb - of[0]->round.begin()),
                upper.placed,
                lower.placed,
                upper.placed_round,
                of.size() < 2,
                {}};
    for (int v = 0; v < open.garment.vertex_count; ++v)
      if (cloth[open.sewn[v]] == root) {
        piece.vertices.push_back(v);
        of_panel_[open.garment.vertex_panel[v]] = static_cast<int>(pieces_.size());
      }
    pieces_.push_back(std::move(piece));
  }
}

bool LimbPieces::is_of_limb(Limb limb, std::size_t skin_vertex) const {
  if (skin_vertex >= body_->segment.size()) return true;
  const body::Segment s = body_->segment[skin_vertex];
  if (limb == kHead) return s == body::Segment::head || s == body::Segment::neck;
  const bool of_arm =
      s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
  const bool of_leg =
      s == body::Segment::thigh || s == body::Segment::shank || s == body::Segment::foot;
  const int side = limb == kLeftArm || limb == kLeftLeg ? 1 : -1;
  return (is_arm(limb) ? of_arm : of_leg) && body_->side[skin_vertex] == side;
}

void LimbPieces::lay(const pattern::Pattern& pattern, std::vector<Vec3>& x,
                     std::vector<Vec3>& outside) const {
  for (const Piece& piece : pieces_) lay_piece(piece, pattern, x, outside);
}

void LimbPieces::lay_piece(const Piece& piece, const pattern::Pattern& pattern,
                           std::vector<Vec3>& x, std::vector<Vec3>& outside) const {
  Vec3 centre = Vec3::Zero();
  for (int v : piece.vertices) centre += x[v] / static_cast<double>(piece.vertices.size());
  const Polyline rest = line_of(at_rest_, piece.limb), worn = line_of(worn_, piece.limb);
  // The limb moves rigidly from rest to the posture, as far as it goes through the piece.
  double s = rest.project(centre);
  Vec3 from = rest.at(s).point, to = worn.at(s).point, along = rest.at(s).tangent;
  if (!piece.is_round) {
    from = piece.upper;
    const double way =
        is_arm(piece.limb) ? (from - rest.at(0).point).norm() : std::max(0.0, rest.project(from));
    to = worn.at(way).point;
    if (is_arm(piece.limb)) {
      along = ((piece.one_ended ? centre : piece.lower) - piece.upper).normalized();
      s = way + (centre - from).norm();
    }
  }
  const Mat3 turn = geometry::rotation_between(along, worn.at(s).tangent).toRotationMatrix();
  for (int v : piece.vertices) x[v] = to + turn * (x[v] - from);
  std::set<int> panels;
  for (int v : piece.vertices) panels.insert(open_.garment.vertex_panel[v]);
  const bool foot = piece.one_ended && !is_arm(piece.limb) && piece.limb != kHead;
  enclose(piece, foot ? Vec3(-Vec3::UnitZ()) : worn.at(s).tangent, x);
  for (int k : panels) {
    const int flat = pattern.find_panel(open_.garment.panel_names[k]);
    if (piece.one_ended && is_arm(piece.limb)) refuse_fingers(pattern.panels[flat]);
    const Mat3 frame = turn * pattern.panels[flat].rotation;
    outside[k] = clear_limb(k, piece, frame, x) ? Vec3(Vec3::Zero()) : Vec3(frame.col(2));
  }
}

void LimbPieces::enclose(const Piece& piece, const Vec3& outwards, std::vector<Vec3>& x) const {
  // Limbs lie in the plane of the shoulders, more or less, and panels beside them.
  const Vec3 beside = Vec3::UnitY().cross(outwards);
  const Vec3 u = beside.norm() > 0.1 ? Vec3(beside.normalized()) : outwards.unitOrthogonal();
  const Vec3 w = outwards.cross(u);
  const auto seen = [&](const Vec3& p) { return Vec3(p.dot(u), p.dot(w), p.dot(outwards)); };
  geometry::Box3 cloth, end;
  for (int v : piece.vertices) cloth.extend(seen(x[v]));
  double farthest = -std::numeric_limits<double>::infinity();
  const auto& skin = body_->surface.vertices;
  for (std::size_t i = 0; i < skin.size(); ++i)
    if (is_of_limb(piece.limb, i)) farthest = std::max(farthest, skin[i].dot(outwards));
  if (!std::isfinite(farthest)) return;
  Vec3 by = Vec3::Zero();
  if (piece.one_ended) by.z() = farthest + kAtEnd - cloth.max().z();
  if (std::abs(by.z()) < kAgrees) by.z() = 0;
  // What the piece covers of the limb.
  const double begins = cloth.min().z() + by.z();
  const double ends = piece.one_ended ? farthest : cloth.max().z();
  for (std::size_t i = 0; i < skin.size(); ++i)
    if (const double at = skin[i].dot(outwards);
        is_of_limb(piece.limb, i) && at > begins && at <= ends)
      end.extend(seen(skin[i]));
  if (end.isEmpty()) return;
  for (int k = 0; k < 2; ++k) {
    const double low = end.min()[k] - cloth.min()[k], high = end.max()[k] - cloth.max()[k];
    // Between the two shifts the piece encloses the limb; one that is smaller goes to its middle.
    by[k] = low < high ? 0.5 * (low + high) : std::clamp(0.0, high, low);
  }
  const Vec3 shift = by.x() * u + by.y() * w + by.z() * outwards;
  for (int v : piece.vertices) x[v] += shift;
}

bool LimbPieces::clear_limb(int panel, const Piece& piece, const Mat3& frame,
                            std::vector<Vec3>& x) const {
  const garment::Garment& g = open_.garment;
  const Polyline worn = line_of(worn_, piece.limb);
  Vec3 middle = Vec3::Zero();
  int count = 0;
  for (int v : piece.vertices)
    if (g.vertex_panel[v] == panel) middle += x[v], ++count;
  middle /= count;
  const double s = worn.project(middle);
  const RolledPanel rolled(open_, x, panel, middle, worn.at(s).tangent, frame.col(2));
  if (!rolled.goes_round()) {
    clear_panel(
        open_, panel, frame, kClear, body_,
        [&](std::size_t i) { return is_of_limb(piece.limb, i); }, x);
    return false;
  }
  rolled.place_clear(worn, s, 0, body_, x);
  return true;
}

}  // namespace loosefit::drape
