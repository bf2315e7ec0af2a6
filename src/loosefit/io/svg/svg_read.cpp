#include "loosefit/io/svg/svg_read.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/file_units.h"
#include "loosefit/io/pieces/piece_collector.h"
#include "loosefit/io/svg/svg_freesewing.h"
#include "loosefit/io/svg/svg_pieces.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // bytes
constexpr std::size_t kMostPieces = 200;
constexpr double kLargestUnit = 0.0254;  // that a drawing may be in [m]

std::vector<CountedPiece> pieces_in(const SvgDocument& document, double unit,
                                    const std::string& file, const std::string& size,
                                    LeftOut& left) {
  left = {};
  std::vector<CountedPiece> pieces = document.freesewing
                                         ? freesewing_pieces(document, unit, left)
                                         : drawn_pieces(document, unit, file, size, left);
  left.sum_up();
  return pieces;
}

double longest_side(const std::vector<CountedPiece>& pieces) {
  double longest = 0;
  for (const CountedPiece& piece : pieces) {
    Vec2 low = Vec2::Constant(1e300), high = -low;
    for (const OutlinePoint& p : piece.piece.outline)
      low = low.cwiseMin(p.at), high = high.cwiseMax(p.at);
    if (low.x() <= high.x()) longest = std::max(longest, (high - low).maxCoeff());
  }
  return longest;
}

}  // namespace

PatternFile parse_svg_pattern(const std::string& text, const std::string& file,
                              const PatternWish& wish) {
  const SvgDocument document = parse_svg(text, file);
  if (document.freesewing && !wish.size.empty())
    throw InvalidInput({file, 0, "size"}, '"' + printable(wish.size) + '"',
                       "none: FreeSewing drafts one size");
  const double named = document.unit.mm / 1000;
  LeftOut left;
  // What is too small for a piece is told by the unit, which the largest piece may have to tell.
  double measured_in = wish.units.empty() ? named : choose_units(wish.units, {}, 1, file).metre;
  std::vector<CountedPiece> pieces = pieces_in(document, measured_in, file, wish.size, left);
  if (pieces.empty() && !document.unit.stated && wish.units.empty())
    pieces = pieces_in(document, measured_in = kLargestUnit, file, wish.size, left);
  if (pieces.empty())
    throw InvalidInput({file, 0, "pieces"},
                       fmt::format("{} shapes, none of them a closed line of more than 4 cm2",
                                   document.shapes.size()),
                       document.freesewing ? "parts of a FreeSewing design" : "closed outlines",
                       "draw each piece as one closed path and name it");
  if (pieces.size() > kMostPieces)
    throw InvalidInput({file, 0, "pieces"}, fmt::format("{} pieces", pieces.size()),
                       fmt::format("at most {}", kMostPieces));
  const auto of_size = std::count_if(pieces.begin(), pieces.end(),
                                     [](const CountedPiece& piece) { return piece.of_size; });
  if (!wish.size.empty() && of_size == 0)
    throw InvalidInput({file, 0, "size"}, '"' + printable(wish.size) + '"',
                       "none: no outlines of several sizes lie in each other in this drawing");
  PatternFile result;
  result.placed = false;
  SaidUnits says;
  says.page = document.unit;
  const FileUnits units = choose_units(wish.units, says, longest_side(pieces) / measured_in, file);
  if (!units.warning.empty()) result.warnings.push_back(units.warning);
  if (units.metre != measured_in) pieces = pieces_in(document, units.metre, file, wish.size, left);
  result.about.push_back(
      fmt::format("{}, in {}", document.freesewing ? "FreeSewing SVG" : "SVG", units.name));
  if (of_size > 0)
    result.about.push_back(
        fmt::format("size {} by the labels of {} outlines", printable(wish.size), of_size));
  std::vector<DrawnPiece*> drawn;
  for (CountedPiece& piece : pieces) drawn.push_back(&piece.piece);
  point_grains_up(drawn);
  PieceCollector collector(result);
  int without_grain = 0;
  for (CountedPiece& piece : pieces) {
    without_grain += !piece.piece.grain && !document.freesewing;
    collector.add(std::move(piece.piece), piece.count, piece.place);
  }
  collector.finish(file, "sew line");
  if (without_grain > 0)
    result.warnings.push_back(fmt::format(
        "{} pieces have no grain line (a line called \"grain\"): the warp is taken up the page",
        without_grain));
  result.unused.insert(result.unused.end(), left.unused.begin(), left.unused.end());
  result.warnings.insert(result.warnings.end(), left.warnings.begin(), left.warnings.end());
  result.unused.insert(result.unused.end(), document.unused.begin(), document.unused.end());
  return result;
}

PatternFile read_svg_pattern(const std::filesystem::path& path, const PatternWish& wish) {
  PatternFile result =
      parse_svg_pattern(read_text_file(path.string(), kLargestFile), path.string(), wish);
  result.pattern.name = path.stem().string();
  return result;
}

}  // namespace loosefit::io
