#include "loosefit/report/svg.h"

#include <fmt/format.h>

#include "loosefit/report/html.h"

namespace loosefit::report {

std::string svg_open(double width, double height, const std::string& label) {
  return fmt::format(
      "<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" style=\"max-width:{0:.0f}px;width:100%\" "
      "role=\"img\" aria-label=\"{2}\">\n",
      width, height, escaped(label));
}

std::string svg_line(double x1, double y1, double x2, double y2, const std::string& look) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>", x1, y1,
                     x2, y2, look);
}

std::string svg_text(double x, double y, const std::string& anchor, const std::string& content,
                     const std::string& more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, content);
}

}  // namespace loosefit::report
