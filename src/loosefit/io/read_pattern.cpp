#include "loosefit/io/read_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/file_kind.h"
#include "loosefit/io/freesewing_json.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/seams_file.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/io/valentina.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pattern/heap.h"
#include "loosefit/pattern/known_skirt.h"
#include "loosefit/pattern/place_pieces.h"

namespace loosefit::io {
namespace {

/// Enough of a file to tell its kind; empty when it cannot be read, which its reader then tells.
std::string beginning(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string text(1 << 16, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

/// A piece by itself has no partner that seams could be proposed with.
void tell_single_piece(PatternFile& file) {
  const pattern::Panel& piece = file.pattern.panels.front();
  if (std::ranges::any_of(piece.holes, pattern::may_be_neck)) {
    file.not_placed =
        "it has no seams: its one piece has a hole that may be a neck, as a poncho or tabard has, "
        "and nothing says where it is folded over the shoulders";
    file.not_placed_hint =
        "draw it as two pieces, front and back, that end at the shoulders, and sew them there in a "
        "side file";
  } else {
    file.not_placed =
        "it has no seams: its one piece is sewn to nothing, and what is wrapped, tied or fastened "
        "is not put on";
    file.not_placed_hint = "sew two of its edges to each other in a side file, as a tube is";
  }
}

/// Seams of a side file, or those of a known garment.
void sew(PatternFile& file, const std::filesystem::path& from) {
  if (!from.empty()) {
    read_seams(from, file);
    file.about.push_back("seams from " + from.string());
    if (!file.pattern.stitches.empty()) return;
  }
  const pattern::KnownGarment known = pattern::know_garment(file.pattern);
  // Whoever wrote a side file has looked at the pieces.
  std::vector<std::string> doubts = known.doubts;
  if (from.empty()) doubts.insert(doubts.end(), file.doubts.begin(), file.doubts.end());
  if (known.certain() && doubts.empty()) {
    const std::size_t count = known.seams.size();
    pattern::sew_chains(file.pattern, known.seams, file.notches);
    file.about.push_back(
        fmt::format("sewn by what its pieces are, {}: {} seams whose lengths agree or that a band "
                    "gathers, and no other way to sew it",
                    known.kind, count));
    return;
  }
  if (known.kind.empty() && file.pattern.panels.size() == 1) return tell_single_piece(file);
  file.not_placed = "it has no seams: none in a side file, and ";
  file.not_placed += known.kind.empty()
                         ? std::string("its pieces are not those of a garment that is known")
                         : "as " + known.kind + " it leaves doubts (" + join(doubts, "; ") + ")";
  if (known.certain())
    file.not_placed_hint =
        "draw the fold (a line called \"fold\", in a DXF one on layer 6), or, if the pieces are "
        "whole as drawn, confirm their seams in a side file (--propose-seams)";
}

/// \param side_file that says how it is sewn; empty: none
void place(PatternFile& file, const std::filesystem::path& side_file) {
  try {
    for (const std::string& note : pattern::place_pieces(file.pattern, file.turns))
      file.warnings.push_back(note);
    file.placed = true;
  } catch (const GeometryError& error) {
    file.placed = false;
    file.not_placed = error.found();
    file.not_placed_hint =
        side_file.empty() ? error.hint() : "in " + side_file.string() + ": " + error.hint();
  }
}

/// A file with seams of its own whose panels lie on each other.
void place_heap(PatternFile& file) {
  const kinds::GarmentKind& kind = kinds::garment_kind(file.pattern.kind);
  if (kind.lay || file.pattern.stitches.empty() || !pattern::lies_in_a_heap(file.pattern)) return;
  std::erase_if(file.warnings,
                [](const std::string& line) { return line.ends_with(kMissingPose); });
  place(file, {});
  if (file.placed)
    file.warnings.push_back(
        "the file does not say where its panels go, which lie on each other (translation, "
        "rotation): they are arranged by what they are");
  else
    file.not_placed_hint =
        "call the panels front, back, sleeve and the like, left or right, or place them round a "
        "body (translation, rotation)";
}

}  // namespace

PatternFile read_unsewn(const std::filesystem::path& path, const PatternWish& wish) {
  // Whatever is asked of a file that is not there: its reader says so.
  if (std::error_code ignored; !std::filesystem::exists(path, ignored))
    return read_garmentcode(path);
  const std::string kind = kind_of_file(beginning(path));
  if (kind == "a DXF file") return read_dxf_pattern(path, wish);
  if (kind == "an SVG drawing") return read_svg_pattern(path, wish);
  if (kind == "a FreeSewing file") return read_freesewing_json(path, wish);
  if (kind == kValentinaKind) return read_valentina(path, wish);
  for (const auto& [key, value] : {std::pair{"size", wish.size}, std::pair{"units", wish.units}})
    if (!value.empty())
      throw InvalidInput({path.string(), 0, key}, '"' + printable(value) + '"',
                         "none: only files that draw pieces have sizes and units to choose from");
  return read_garmentcode(path);
}

PatternFile read_pattern(const std::filesystem::path& path, const PatternWish& wish,
                         const std::filesystem::path& seams) {
  PatternFile result = read_unsewn(path, wish);
  if (result.placed) {
    if (!seams.empty())
      throw InvalidInput({path.string(), 0, "seams"}, '"' + printable(seams.string()) + '"',
                         "none: the file has its seams itself");
    place_heap(result);
    return result;
  }
  const std::filesystem::path from = side_file(path, seams);
  sew(result, from);
  if (!result.pattern.stitches.empty()) place(result, from);
  return result;
}

}  // namespace loosefit::io
