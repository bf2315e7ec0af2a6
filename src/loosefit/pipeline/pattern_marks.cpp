#include "loosefit/pipeline/pattern_marks.h"

#include <cmath>
#include <variant>

namespace loosefit::pipeline {
namespace {

constexpr int kDisc = 72;  // corners

std::vector<Vec2> rectangle(const Vec2& at, const Vec2& across, const Vec2& along) {
  return {at - across - along, at + across - along, at + across + along, at - across + along};
}

std::vector<Vec2> disc(const Vec2& at, double radius) {
  std::vector<Vec2> points;
  for (int i = 0; i < kDisc; ++i)
    points.push_back(at +
                     radius * Vec2(std::cos(2 * kPi * i / kDisc), std::sin(2 * kPi * i / kDisc)));
  return points;
}

}  // namespace

io::PatternMark sensor_mark(const std::string& name, const std::string& panel, const Vec2& at,
                            double angle, const placement::FootprintShape& shape) {
  using Kind = placement::FootprintShape::Kind;
  const Vec2 along = placement::axis_in_pattern(angle), across(along.y(), -along.x());
  switch (shape.kind) {
    case Kind::disc:
      return {name, panel, disc(at, shape.radius), true};
    case Kind::rectangle:
      return {name, panel, rectangle(at, shape.size.x() / 2 * across, shape.size.y() / 2 * along),
              true};
    case Kind::line:
      return {name, panel, {at - shape.length / 2 * along, at + shape.length / 2 * along}, false};
    case Kind::girth:
      break;
  }
  return {name, panel, {at}, false};
}

std::vector<io::PatternMark> scenario_marks(const scenario::Scenario& scenario) {
  std::vector<io::PatternMark> marks;
  for (const garment::Attachment& a : scenario.attachments) {
    if (const auto* cable = std::get_if<garment::Cable>(&a.part)) {
      marks.push_back({a.name, a.panel, cable->path, false});
      continue;
    }
    const auto& board = std::get<garment::Board>(a.part);
    const Vec2 u(std::cos(board.angle), std::sin(board.angle)), v(-u.y(), u.x());
    marks.push_back({a.name, a.panel,
                     board.radius > 0
                         ? disc(board.centre, board.radius)
                         : rectangle(board.centre, board.size.x() / 2 * u, board.size.y() / 2 * v),
                     true});
  }
  for (const placement::SiteSpec& site : scenario.sites)
    if (!site.panel.empty())  // beyond a seam it is drawn where it would lie if the piece went on
      marks.push_back(
          sensor_mark(site.name, site.panel, site.at + site.shift, site.angle, site.footprint));
  return marks;
}

std::vector<io::PatternMark> ranking_marks(const placement::RankingTable& table) {
  std::vector<io::PatternMark> marks;
  for (const placement::RankedSite& site : table.ranking.sites) {
    if (!site.score.rated() || !(site.score.robust > 0)) continue;
    const placement::RankedPlace& place = table.places[site.index];
    if (place.panel.empty()) continue;
    marks.push_back(sensor_mark(site.name, place.panel, place.at, place.angle, place.shape));
  }
  return marks;
}

}  // namespace loosefit::pipeline
