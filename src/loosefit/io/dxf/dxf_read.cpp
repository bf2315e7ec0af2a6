#include "loosefit/io/dxf/dxf_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/dxf/dxf_document.h"
#include "loosefit/io/dxf/dxf_drawn_piece.h"
#include "loosefit/io/dxf/dxf_pieces.h"
#include "loosefit/io/pieces/file_units.h"
#include "loosefit/io/pieces/left_out.h"
#include "loosefit/io/pieces/piece_collector.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kLargestFile = 64u << 20;  // bytes
constexpr std::size_t kMostPieces = 200;
constexpr std::size_t kMostKinds = 12;  // of things that one line names

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
    case 20:
      return "sensor places and cable paths of Loosefit";
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

/// Without pieces of another cloth, which would stand for pieces of the garment. A file of nothing
/// else is that of a lining, which is read.
std::vector<const DxfPiece*> of_own_cloth(const std::vector<const DxfPiece*>& pieces,
                                          std::vector<std::string>& warnings) {
  std::vector<const DxfPiece*> own;
  std::vector<std::string> told;
  for (const DxfPiece* piece : pieces)
    if (const std::string why = of_other_cloth(*piece); why.empty())
      own.push_back(piece);
    else
      told.push_back("piece " + printable(piece->name) + ": left out, it is of another cloth by " +
                     printable(why));
  if (own.empty()) return pieces;
  warnings.insert(warnings.end(), told.begin(), told.end());
  return own;
}

/// Without blocks that are drawn by hidden inserts alone, and without test squares and frames.
std::vector<const DxfPiece*> seen_pieces(const DxfDocument& document,
                                         const std::vector<const DxfPiece*>& pieces,
                                         std::vector<std::string>& warnings) {
  std::map<std::string, std::string> hidden;
  std::set<std::string> seen;
  for (const DxfEntity& e : document.entities)
    if (e.kind == "INSERT")
      e.hidden.empty() ? (void)seen.insert(e.text) : (void)hidden.emplace(e.text, e.hidden);
  std::vector<const DxfPiece*> kept;
  for (const DxfPiece* piece : pieces) {
    const auto why = hidden.find(piece->block->name);
    if (const pattern::PieceWords words = pattern::words_of(piece->name);
        words.sheet && !names_cloth(words))
      warnings.push_back("piece " + printable(piece->name) +
                         ": left out, it is called after a test square, a frame or a title");
    else if (why == hidden.end() || seen.count(piece->block->name))
      kept.push_back(piece);
    else
      warnings.push_back("piece " + printable(piece->name) +
                         ": left out, its block is hidden: " + why->second);
  }
  return kept;
}

/// Counts what the blocks hold beyond what a panel is made of.
void list_unused(const std::vector<const DxfPiece*>& pieces, std::vector<std::string>& unused) {
  std::map<int, std::map<std::string, int>> left;
  for (const DxfPiece* piece : pieces)
    for (const DxfEntity& e : piece->block->entities) {
      const bool text = e.kind == "TEXT" || e.kind == "MTEXT";
      const bool line = e.points.size() > 1;
      const bool used =
          text ? is_known_text(e.text) || find_quantity(e.text)
               : (line && (e.layer == 1 || e.layer == 6 || e.layer == 7 || e.layer == 84 ||
                           e.layer == 14 || e.layer == 11)) ||
                     e.layer == 2 ||
                     ((e.layer == 4 || (e.layer >= 80 && e.layer <= 83)) && !e.points.empty());
      // A symbol is told by the name of its block.
      if (!used)
        ++left[e.layer]
              [e.kind == "INSERT" || text ? e.kind + " " + quoted(e.text.substr(0, 40)) : e.kind];
    }
  for (const auto& [layer, kinds] : left) {
    std::vector<std::string> counts;
    for (const auto& [kind, count] : kinds) {
      if (counts.size() == kMostKinds) {
        counts.push_back(fmt::format("and {} more kinds", kinds.size() - kMostKinds));
        break;
      }
      counts.push_back(fmt::format("{} {}", count, printable(kind, 60)));
    }
    unused.push_back((layer < 0 ? std::string("layers whose name is no number")
                                : fmt::format("layer {} ({})", layer, layer_meaning(layer))) +
                     ": " + join(counts));
  }
}

/// Kinds of things that enclose something and that are not read.
std::string unread_kinds(const DxfBlock& block) {
  std::map<std::string, int> kinds;
  for (const DxfEntity& e : block.entities)
    for (const char* kind :
         {"HATCH", "REGION", "SOLID", "TRACE", "3DFACE", "3DSOLID", "BODY", "MLINE", "WIPEOUT",
          "POLYLINE (mesh)", "PROXY", "IMAGE", "ACAD_PROXY_ENTITY"})
      if (e.kind == kind) ++kinds[e.kind];
  std::vector<std::string> list;
  for (const auto& [kind, count] : kinds) list.push_back(fmt::format("{} {}", count, kind));
  return join(list);
}

bool is_closed(const DxfEntity& e) { return e.closed && e.points.size() > 2; }

/// Blocks and lines that are no pieces.
void list_what_is_no_piece(const DxfDocument& document, const DxfStyle& style, LeftOut& left) {
  for (const DxfBlock& block : document.blocks) {
    const bool taken = std::any_of(style.pieces.begin(), style.pieces.end(),
                                   [&](const DxfPiece& piece) { return piece.block == &block; });
    const bool closed = std::any_of(block.entities.begin(), block.entities.end(), is_closed);
    if (taken || block.name.starts_with("*")) continue;
    const std::string called =
        fmt::format("block {} at line {}: left out, ", quoted(block.name), block.line);
    const auto unseen =
        std::find_if(block.hidden.begin(), block.hidden.end(),
                     [](const DxfEntity& e) { return e.layer == 1 || e.layer == 84; });
    if (unseen != block.hidden.end())
      left.tell(called +
                fmt::format("its line on layer {} is hidden, {}", unseen->layer, unseen->hidden));
    else if (closed)
      left.tell(called + "nothing is drawn on layer 1 or 84");
    else if (const std::string kinds = unread_kinds(block); !kinds.empty())
      left.tell(called + "it has no lines but what is not read: " + kinds);
    else
      left.count("blocks without an outline", block.name);
  }
  int loose = 0, closed = 0, first = 0;
  for (const DxfEntity& e : document.entities) {
    if ((e.kind == "TEXT" || e.kind == "MTEXT") && find_quantity(e.text))
      left.tell(
          fmt::format("text {} at line {} outside of blocks: it belongs to no piece and counts "
                      "nothing",
                      quoted(e.text), e.line));
    loose += e.points.size() > 1;
    if (!is_closed(e)) continue;
    if (closed++ == 0) first = e.line;
  }
  if (closed > 0)
    left.tell(
        fmt::format("{} closed lines outside of blocks, the first at line {}: left out, "
                    "pieces are blocks",
                    closed, first));
  if (loose > closed)
    left.unused.push_back(fmt::format("lines outside of blocks: {}", loose - closed));
}

/// What is hidden in blocks that are pieces.
void list_hidden(const std::vector<const DxfPiece*>& pieces, LeftOut& left) {
  std::map<std::pair<int, std::string>, std::vector<std::string>> names;
  for (const DxfPiece* piece : pieces)
    for (const DxfEntity& e : piece->block->hidden) {
      std::vector<std::string>& of = names[{e.layer, e.hidden}];
      if (of.empty() || of.back() != printable(piece->name)) of.push_back(printable(piece->name));
    }
  for (const auto& [what, of] : names) {
    const std::vector<std::string> some(of.begin(),
                                        of.begin() + std::min<std::size_t>(of.size(), 6));
    left.tell(fmt::format("lines on layer {} ({}) of {}{} are hidden and not used: {}", what.first,
                          layer_meaning(what.first), join(some),
                          of.size() > some.size() ? ", ..." : "", what.second));
  }
}

/// A block that is drawn several times, or in another one, or not at all, is one piece all the
/// same.
void tell_inserts(const DxfDocument& document, const std::vector<const DxfPiece*>& pieces,
                  LeftOut& left) {
  const auto of = [](const std::vector<DxfEntity>& entities, const std::string& name) {
    return std::count_if(entities.begin(), entities.end(), [&](const DxfEntity& e) {
      return e.kind == "INSERT" && e.text == name && e.hidden.empty();
    });
  };
  for (const DxfPiece* piece : pieces) {
    const std::string& name = piece->block->name;
    const auto same = std::count_if(document.blocks.begin(), document.blocks.end(),
                                    [&](const DxfBlock& block) { return block.name == name; });
    if (const auto times = of(document.entities, name); times > 1 && same == 1)
      left.tell(
          fmt::format("block {}: it is drawn {} times (INSERT) and taken as one piece; its "
                      "quantity says how often it is cut",
                      quoted(name), times));
    for (const DxfBlock& other : document.blocks)
      if (&other != piece->block && of(other.entities, name) > 0)
        left.tell(fmt::format("block {}: it is drawn in block {} and taken as a piece of its own",
                              quoted(name), quoted(other.name)));
  }
}

/// How often a piece is cut, by its quantity, else by an annotation or another text.
PieceCount count_of(const DxfPiece& piece, std::vector<std::string>& warnings) {
  const std::string called = "piece " + printable(piece.name) + ": ";
  std::optional<PieceCount> count;
  if (!piece.quantity.empty()) {
    count = read_quantity(piece.quantity);
    if (!count) {
      warnings.push_back(called + "its quantity " + quoted(piece.quantity) +
                         " is no number; taken as 1");
      count = PieceCount{};
    }
  }
  std::vector<std::string> texts = piece.texts;
  texts.insert(texts.begin(), piece.annotation);
  for (const std::string& text : texts) {
    const std::optional<PieceCount> said = find_quantity(text);
    if (!said && speaks_of_count(text))
      warnings.push_back(called + "its text " + quoted(text) +
                         " may say how often it is cut and is not understood: it counts nothing");
    if (!said) continue;
    if (!count)
      count = said;
    else if (said->as_drawn != count->as_drawn || said->mirrored != count->mirrored)
      warnings.push_back(called + "it is said to be cut as " +
                         quoted(count->said.empty() ? piece.quantity : count->said) + " and as " +
                         quoted(said->said) + ": the first is taken");
  }
  return count.value_or(PieceCount{});
}

/// Why a file has no pieces.
std::string without_pieces(const DxfDocument& document) {
  std::string found = fmt::format("{} blocks, none with lines on layer 1", document.blocks.size());
  for (const DxfBlock& block : document.blocks)
    for (const DxfEntity& e : block.hidden)
      if (e.layer == 1 || e.layer == 84) return found + " that can be seen: " + e.hidden;
  const auto closed = std::count_if(document.entities.begin(), document.entities.end(), is_closed);
  if (closed > 0) found += fmt::format(", and {} closed lines outside of blocks", closed);
  return found;
}

}  // namespace

PatternFile parse_dxf_pattern(const std::string& text, const std::string& file,
                              const PatternWish& wish) {
  if (text.starts_with("AutoCAD Binary DXF"))
    throw InvalidInput({file, 0, {}}, "a binary DXF file", "a DXF file in text form",
                       "export it as ASCII DXF");
  const DxfDocument document = parse_dxf(text, file);
  const DxfStyle style = find_pieces(document);
  if (style.pieces.empty())
    throw InvalidInput({file, 0, "BLOCKS"}, without_pieces(document),
                       "pieces as blocks, their boundary on layer 1 (DXF-AAMA, ASTM D6673)",
                       "export it as AAMA or ASTM DXF, not as a drawing");
  PatternFile result;
  result.placed = false;
  result.pattern.name = style.name;
  const std::string size = chosen_size(style, wish.size, file);
  const std::vector<const DxfPiece*> all = pieces_of(style, size, result.warnings);
  const std::size_t before = result.warnings.size();
  const std::vector<const DxfPiece*> pieces =
      of_own_cloth(seen_pieces(document, all, result.warnings), result.warnings);
  // What is left out by its cloth or because nobody sees it belongs to the account as well.
  result.unused.assign(result.warnings.begin() + static_cast<std::ptrdiff_t>(before),
                       result.warnings.end());
  if (pieces.empty())
    throw InvalidInput({file, 0, "BLOCKS"}, result.warnings.back(), "a piece that can be seen",
                       "show its layer, and export the file again");
  if (pieces.size() > kMostPieces)
    throw InvalidInput({file, 0, "BLOCKS"}, fmt::format("{} pieces of one size", pieces.size()),
                       fmt::format("at most {}", kMostPieces));
  const FileUnits units =
      choose_units(wish.units, {style.units, document.insunits, style.maker, document.metric},
                   longest_side(pieces), file);
  result.about.push_back("DXF-AAMA or ASTM D6673, in " + units.name);
  if (!units.warning.empty()) result.warnings.push_back(units.warning);
  if (!size.empty())
    result.about.push_back(fmt::format("size {} of {}{}", printable(size),
                                       printable(join(style.sizes), 300),
                                       size == style.sample_size ? ", the sample size" : ""));
  std::vector<CountedPiece> drawn;
  for (const DxfPiece* piece : pieces) {
    const PieceCount count = count_of(*piece, result.warnings);
    for (DrawnPiece& one : pieces_of_block(*piece, units.metre))
      drawn.push_back({std::move(one), count, fmt::format("block at line {}", piece->block->line)});
  }
  std::vector<DrawnPiece*> pointers;
  for (CountedPiece& one : drawn) pointers.push_back(&one.piece);
  point_grains_up(pointers);
  PieceCollector collector(result);
  for (CountedPiece& one : drawn) collector.add(std::move(one.piece), one.count, one.place);
  collector.finish(file, "sew line (layer 14)");
  LeftOut left;
  list_what_is_no_piece(document, style, left);
  list_hidden(pieces, left);
  tell_inserts(document, pieces, left);
  left.sum_up();
  list_unused(pieces, left.unused);
  result.unused.insert(result.unused.end(), left.unused.begin(), left.unused.end());
  result.warnings.insert(result.warnings.end(), left.warnings.begin(), left.warnings.end());
  if (all.size() < style.pieces.size())
    result.unused.push_back(
        fmt::format("{} pieces of other sizes", style.pieces.size() - all.size()));
  return result;
}

PatternFile read_dxf_pattern(const std::filesystem::path& path, const PatternWish& wish) {
  PatternFile result =
      parse_dxf_pattern(read_plain_text(path.string(), kLargestFile), path.string(), wish);
  result.pattern.name = path.stem().string();
  return result;
}

}  // namespace loosefit::io
