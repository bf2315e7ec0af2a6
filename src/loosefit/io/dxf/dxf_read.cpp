#include "loosefit/io/dxf/dxf_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/dxf/dxf_document.h"
#include "loosefit/io/dxf/dxf_panel.h"
#include "loosefit/io/dxf/dxf_pieces.h"
#include "loosefit/io/dxf/dxf_units.h"
#include "loosefit/io/garmentcode_frame.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // bytes
constexpr std::size_t kMostPieces = 200, kMostPoints = 50'000;
constexpr double kGap = 0.05;  // between pieces laid side by side [m]

std::string quoted(const std::string& s) { return '"' + printable(s) + '"'; }

const char* layer_meaning(int layer) {
  switch (layer) {
    case 1:
      return "boundary";
    case 2:
      return "turn points";
    case 3:
      return "curve points";
    case 4:
      return "notches";
    case 5:
      return "grade reference";
    case 6:
      return "mirror line";
    case 7:
      return "grain line";
    case 8:
      return "internal lines";
    case 9:
      return "stripe reference";
    case 10:
      return "plaid reference";
    case 11:
      return "internal cutouts";
    case 13:
      return "drill holes";
    case 14:
      return "sew line";
    case 15:
      return "annotation";
    case 80:
    case 81:
    case 82:
    case 83:
      return "notches";
    case 84:
    case 85:
    case 86:
    case 87:
      return "validation curves";
    default:
      return "no meaning in ASTM D6673";
  }
}

std::string chosen_size(const DxfStyle& style, const std::string& asked, const std::string& file) {
  const auto has = [&](const std::string& size) {
    return std::find(style.sizes.begin(), style.sizes.end(), size) != style.sizes.end();
  };
  if (!asked.empty()) {
    if (has(asked)) return asked;
    throw InvalidInput(
        {file, 0, "size"}, quoted(asked),
        style.sizes.empty() ? "no size, the pieces of the file have none" : "a size of the file",
        style.sizes.empty() ? "" : did_you_mean(asked, style.sizes));
  }
  if (has(style.sample_size)) return style.sample_size;
  if (style.sizes.size() == 1) return style.sizes[0];
  if (style.sizes.empty()) return {};
  throw InvalidInput(
      {file, 0, "size"},
      fmt::format("{} sizes ({}) and {}", style.sizes.size(), printable(join(style.sizes), 200),
                  style.sample_size.empty() ? std::string("no sample size")
                                            : "the sample size " + quoted(style.sample_size) +
                                                  ", which none of the pieces has"),
      "one that is asked for", "name one: --size");
}

/// Pieces of the size, those that have no size, and those that exist in one other size only.
std::vector<const DxfPiece*> pieces_of(const DxfStyle& style, const std::string& size,
                                       std::vector<std::string>& warnings) {
  std::map<std::string, std::set<std::string>> sizes_of;
  for (const DxfPiece& piece : style.pieces) sizes_of[piece.name].insert(piece.size);
  std::vector<const DxfPiece*> chosen;
  std::set<std::string> missed;
  for (const DxfPiece& piece : style.pieces) {
    const std::set<std::string>& sizes = sizes_of[piece.name];
    if (piece.size == size || piece.size.empty()) {
      chosen.push_back(&piece);
    } else if (sizes.count(size) == 0 && missed.insert(piece.name).second) {
      if (sizes.size() == 1) {
        chosen.push_back(&piece);
        warnings.push_back("piece " + printable(piece.name) + ": only in size " +
                           quoted(piece.size) + ", which is taken");
      } else {
        warnings.push_back("piece " + printable(piece.name) + ": left out, it has no size " +
                           quoted(size));
      }
    }
  }
  return chosen;
}

double longest_side(const std::vector<const DxfPiece*>& pieces) {
  double longest = 0;
  for (const DxfPiece* piece : pieces) {
    Vec2 low = Vec2::Constant(1e300), high = -low;
    for (const DxfEntity& e : piece->block->entities)
      if (e.layer == 1 && e.points.size() > 1)
        for (const Vec2& p : e.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    if (low.x() <= high.x()) longest = std::max(longest, (high - low).maxCoeff());
  }
  return longest;
}

/// Counts what the blocks hold beyond what a panel is made of.
void list_unused(const std::vector<const DxfPiece*>& pieces, const DxfDocument& document,
                 bool sew_lines, std::vector<std::string>& unused) {
  std::map<int, std::map<std::string, int>> left;
  for (const DxfPiece* piece : pieces)
    for (const DxfEntity& e : piece->block->entities) {
      const bool text = e.kind == "TEXT" || e.kind == "MTEXT";
      const bool line = e.points.size() > 1;
      const bool used = text ? is_known_text(e.text)
                             : (line && (e.layer == 1 || e.layer == 6 || e.layer == 7 ||
                                         e.layer == 84 || (e.layer == 14 && sew_lines))) ||
                                   e.layer == 2 || e.layer == 4 || (e.layer >= 80 && e.layer <= 83);
      if (!used) ++left[e.layer][e.kind];
    }
  for (const auto& [layer, kinds] : left) {
    std::vector<std::string> counts;
    for (const auto& [kind, count] : kinds)
      counts.push_back(fmt::format("{} {}", count, printable(kind, 20)));
    unused.push_back((layer < 0 ? std::string("layers whose name is no number")
                                : fmt::format("layer {} ({})", layer, layer_meaning(layer))) +
                     ": " + join(counts));
  }
  std::size_t loose = 0;
  for (const DxfEntity& e : document.entities) loose += e.points.size() > 1;
  if (loose > 0) unused.push_back(fmt::format("lines outside of blocks: {}", loose));
}

class PatternMaker {
 public:
  PatternMaker(PatternFile& result, double metre) : result_(result), metre_(metre) {}

  void add(const DxfPiece& piece) {
    const std::string called = "piece " + printable(piece.name);
    PieceCount count;
    if (!piece.quantity.empty() && !parse_quantity(piece.quantity, count))
      warn(called + ": its quantity " + quoted(piece.quantity) + " is no number; taken as 1");
    if (count.as_drawn + count.mirrored == 0) {
      result_.unused.push_back(called + ": its quantity is 0, it is optional");
      return;
    }
    DxfPanel made = make_panel(piece, metre_);
    if (!made.fault.empty()) {
      warn(fmt::format("{} (block at line {}): left out, {}", called, piece.block->line,
                       printable(made.fault, 300)));
      return;
    }
    for (const std::string& note : made.notes) warn(called + ": " + note);
    (made.on_sew_line ? on_sew_line_ : on_cut_line_) += 1;
    unfolded_ += made.unfolded;
    if (count.as_drawn > 1 || count.mirrored > 1)
      warn(called + ": its quantity is " + printable(piece.quantity) +
           "; one of each hand is taken, further ones are not");
    for (const pattern::PanelEdge& edge : made.panel.edges) points_ += edge.curves.size();
    if (points_ > kMostPoints)
      throw InvalidInput(called, fmt::format("at most {} points in all pieces", kMostPoints));
    if (count.as_drawn > 0) place(made);
    if (count.mirrored > 0) {
      DxfPanel twin = mirrored_piece(made);
      if (count.as_drawn > 0) twin.panel.name += "_mirrored", ++twins_;
      place(std::move(twin));
    }
  }

  void finish(const std::string& file) {
    if (result_.pattern.panels.empty())
      throw GeometryError(
          {file, 0, "pieces"},
          result_.warnings.empty() ? "no piece that is cut at all" : result_.warnings.back(),
          "at least one sound piece");
    if (unfolded_ > 0)
      result_.about.push_back(
          fmt::format("{} half pieces unfolded at their mirror line", unfolded_));
    if (twins_ > 0)
      result_.about.push_back(
          fmt::format("{} pieces cut twice: once as drawn, once mirrored", twins_));
    if (on_sew_line_ > 0)
      result_.about.push_back(fmt::format("{} pieces along their sew line", on_sew_line_));
    if (on_cut_line_ > 0)
      warn(
          fmt::format("{} pieces have no sew line (layer 14): taken as they are cut; where that "
                      "includes seam allowances, the garment is that much too wide",
                      on_cut_line_));
  }

 private:
  void warn(const std::string& warning) { result_.warnings.push_back(warning); }

  void place(DxfPanel piece) {
    pattern::Panel& panel = piece.panel;
    const std::string name = panel.name;
    for (int k = 2; result_.pattern.find_panel(panel.name) >= 0; ++k)
      panel.name = fmt::format("{}_{}", name, k);
    Vec2 low = Vec2::Constant(1e9), high = -low;
    for (const Vec2& p : pattern::outline_polygon(panel))
      low = low.cwiseMin(p), high = high.cwiseMax(p);
    panel.translation = frame_from_y_up() * Vec3(right_ - low.x(), 0, 0);
    panel.rotation = frame_from_y_up();
    right_ += high.x() - low.x() + kGap;
    const int index = static_cast<int>(result_.pattern.panels.size());
    for (pattern::Notch& notch : piece.notches) {
      notch.panel = index;
      result_.notches.push_back(notch);
    }
    result_.pattern.panel_order.push_back(index);
    result_.pattern.panels.push_back(std::move(panel));
  }

  PatternFile& result_;
  double metre_, right_ = 0;
  int on_sew_line_ = 0, on_cut_line_ = 0, unfolded_ = 0, twins_ = 0;
  std::size_t points_ = 0;
};

}  // namespace

PatternFile parse_dxf_pattern(const std::string& text, const std::string& file,
                              const DxfWish& wish) {
  if (text.starts_with("AutoCAD Binary DXF"))
    throw InvalidInput({file, 0, {}}, "a binary DXF file", "a DXF file in text form",
                       "export it as ASCII DXF");
  const DxfDocument document = parse_dxf(text, file);
  const DxfStyle style = find_pieces(document);
  if (style.pieces.empty())
    throw InvalidInput({file, 0, "BLOCKS"},
                       fmt::format("{} blocks, none with lines on layer 1", document.blocks.size()),
                       "pieces as blocks, their boundary on layer 1 (DXF-AAMA, ASTM D6673)",
                       "export it as AAMA or ASTM DXF, not as a drawing");
  PatternFile result;
  result.placed = false;
  result.pattern.name = style.name;
  const std::string size = chosen_size(style, wish.size, file);
  const std::vector<const DxfPiece*> pieces = pieces_of(style, size, result.warnings);
  if (pieces.size() > kMostPieces)
    throw InvalidInput({file, 0, "BLOCKS"}, fmt::format("{} pieces of one size", pieces.size()),
                       fmt::format("at most {}", kMostPieces));
  const DxfUnits units =
      choose_units(wish.units, style.units, document.insunits, longest_side(pieces), file);
  result.about.push_back("DXF-AAMA or ASTM D6673, in " + units.name);
  if (!units.warning.empty()) result.warnings.push_back(units.warning);
  if (!size.empty())
    result.about.push_back(fmt::format("size {} of {}{}", printable(size),
                                       printable(join(style.sizes), 300),
                                       size == style.sample_size ? ", the sample size" : ""));
  PatternMaker maker(result, units.metre);
  for (const DxfPiece* piece : pieces) maker.add(*piece);
  maker.finish(file);
  list_unused(pieces, document, true, result.unused);
  if (pieces.size() < style.pieces.size())
    result.unused.push_back(
        fmt::format("{} pieces of other sizes", style.pieces.size() - pieces.size()));
  return result;
}

PatternFile read_dxf_pattern(const std::filesystem::path& path, const DxfWish& wish) {
  PatternFile result =
      parse_dxf_pattern(read_text_file(path.string(), kLargestFile), path.string(), wish);
  result.pattern.name = path.stem().string();
  return result;
}

}  // namespace loosefit::io
