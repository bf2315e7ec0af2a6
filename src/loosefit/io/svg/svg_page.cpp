#include "loosefit/io/svg/svg_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/svg/svg_path.h"

namespace loosefit::io {
namespace {

constexpr double kInch = 25.4;
constexpr double kLastOf90 = 0.915;  // versions of Inkscape: 0.91, and 0.92 after it

constexpr double kSameScale = 1e-3;  // of the page, across and down
// Lengths that only a screen has.
constexpr const char* kOfScreen[] = {"em", "ex", "ch", "vw", "vh", "vmin", "vmax", ")"};

/// A length with its unit: value, and millimetres of the unit, none for a plain number and for px,
/// which stand for a unit that nobody named.
struct Length {
  double value = 0;
  std::optional<double> mm;
  bool percent = false;
};

std::optional<Length> parse_length(std::string text) {
  Length length;
  // A decimal comma is a point, where there is one and no point.
  if (std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos)
    std::replace(text.begin(), text.end(), ',', '.');
  const char* begin = text.data();
  const char* end = text.data() + text.size();
  while (begin != end && (*begin == ' ' || *begin == '\t' || *begin == '+')) ++begin;
  const auto [rest, error] = std::from_chars(begin, end, length.value);
  if (error != std::errc() || !std::isfinite(length.value)) return {};
  std::string unit(rest, end);
  while (!unit.empty() && unit.back() == ' ') unit.pop_back();
  while (!unit.empty() && unit.front() == ' ') unit.erase(0, 1);
  for (char& c : unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (unit == "mm") length.mm = 1;
  if (unit == "cm") length.mm = 10;
  if (unit == "m") length.mm = 1000;
  if (unit == "in" || unit == "inch" || unit == "inches") length.mm = kInch;
  if (unit == "pt") length.mm = kInch / 72;
  if (unit == "pc") length.mm = kInch / 6;
  length.percent = unit == "%";
  if (!length.mm && !length.percent && !unit.empty() && unit != "px") return {};
  return length;
}

/// The pixel of the program that wrote the file.
void set_program(const XmlElement& root, const std::string& text, SvgPage& page) {
  const std::string& version = root.attribute("inkscape:version");
  const bool freesewing = root.attributes.count("freesewing") > 0;
  double number = 0;
  const char* const begin = version.data();
  page.unit = {kInch / page.per_inch, "pixels of 1/96 inch"};
  if (std::from_chars(begin, begin + version.size(), number).ec == std::errc()) {
    page.per_inch = number < kLastOf90 ? 90 : 96;
    page.unit = {kInch / page.per_inch,
                 fmt::format("the file is of Inkscape {}, whose pixels are 1/{:g} inch",
                             printable(version, 20), page.per_inch),
                 true};
  } else if (!root.attribute("sodipodi:version").empty()) {
    page.per_inch = 90;
    page.unit = {kInch / 90, "the file is of Sodipodi, whose pixels are 1/90 inch", true};
  } else if (text.substr(0, 2000).find("Adobe Illustrator") != std::string::npos) {
    // Lengths in the file are pixels all the same, its own unit is not.
    page.unit = {kInch / 72,
                 "the file is of Adobe Illustrator, whose units are points of 1/72 inch", true};
  } else if (freesewing) {
    page.unit = {1, "FreeSewing draws in millimetres", true, true};
  }
}

}  // namespace

double SvgPage::length(const XmlElement& e, const std::string& key, const std::string& file,
                       double fallback) const {
  const std::string& text = e.attribute(key);
  if (text.empty()) return fallback;
  const std::optional<Length> value = parse_length(text);
  if (!value || std::abs(value->value) > 1e7)
    throw InvalidInput({file, e.line, key}, '"' + printable(text) + '"', "a length");
  if (value->percent) {
    const bool along_y = key == "y" || key == "height" || key == "cy";
    return value->value / 100 * (along_y ? (high - low).y() : (high - low).x());
  }
  return value->mm ? value->value * *value->mm * per_inch / kInch : value->value;
}

SvgPage page_of(const XmlElement& root, const std::string& text, const std::string& file) {
  SvgPage page;
  set_program(root, text, page);
  const std::optional<Length> sides[] = {parse_length(root.attribute("width")),
                                         parse_length(root.attribute("height"))};
  // A unit that stands there and is not understood is not passed over for a guess.
  for (int k = 0; k < 2; ++k) {
    const std::string key = k == 0 ? "width" : "height";
    const std::string& side = root.attribute(key);
    const bool of_screen = std::any_of(std::begin(kOfScreen), std::end(kOfScreen),
                                       [&](const char* unit) { return side.ends_with(unit); });
    if (!sides[k] && !of_screen && side.find_first_of("0123456789") != std::string::npos)
      throw InvalidInput({file, root.line, key}, '"' + printable(side, 40) + '"',
                         "a length in mm, cm, m, in, pt, pc or px, or a percentage");
  }
  const std::string& box = root.attribute("viewBox");
  std::vector<double> view;
  if (!box.empty()) {
    view = parse_svg_numbers(box, file, root.line, "viewBox");
    if (view.size() != 4 || !(view[2] > 0) || !(view[3] > 0))
      throw InvalidInput({file, root.line, "viewBox"}, '"' + printable(box) + '"',
                         "four numbers, the last two of them positive");
    page.low = {view[0], view[1]};
    page.high = page.low + Vec2(view[2], view[3]);
  }
  // The drawing is fitted into the page: the smaller scale holds.
  std::optional<PageUnit> stated;
  bool whole = true;  // both sides are there
  for (int k = 0; k < 2; ++k) {
    const std::optional<Length>& side = sides[k];
    const std::string key = k == 0 ? "width" : "height";
    whole = whole && side && !side->percent;
    if (!side || side->percent || !(side->value > 0)) continue;
    if (view.empty()) {
      // Without a viewBox a unit is a pixel whatever the unit of the page.
      if (side->mm && !page.unit.stated)
        page.unit.stated = true,
        page.unit.words =
            "the page has a size but no viewBox, so that its units are pixels of 1/96 inch";
      continue;
    }
    const double mm = side->value * side->mm.value_or(page.unit.mm) / view[2 + k];
    if (stated && std::abs(mm / stated->mm - 1) > kSameScale &&
        root.attribute("preserveAspectRatio").find("none") != std::string::npos)
      throw InvalidInput(
          {file, root.line, "preserveAspectRatio"},
          fmt::format("\"none\" with units of {:.4g} mm across and {:.4g} mm down", stated->mm, mm),
          "one scale for both",
          "width and height of the page do not fit its viewBox: the pieces would be "
          "drawn out of shape");
    if (stated && stated->mm <= mm) continue;
    const std::string words = fmt::format("{} {} over a viewBox of {:g} units", key,
                                          printable(root.attribute(key), 30), view[2 + k]);
    stated = side->mm ? PageUnit{mm, "the file says " + words, true, true}
                      : PageUnit{mm, page.unit.words + ", " + words, page.unit.stated, false};
  }
  if (view.empty() && whole)
    page.high = {page.length(root, "width", file), page.length(root, "height", file)};
  // FreeSewing draws in millimetres where its page names no length.
  const bool known = page.unit.stated && page.unit.exact;
  if (stated && (stated->exact || !known)) page.unit = *stated;
  return page;
}

}  // namespace loosefit::io
