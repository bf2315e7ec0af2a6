#include "loosefit/report/html.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "loosefit/base/text.h"

namespace loosefit::report {

std::string escaped(const std::string& text) {
  std::string safe;
  safe.reserve(text.size());
  for (char c : without_controls(text)) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  return safe;
}

std::string base64(const std::string& bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  std::string text = fmt::format("{:.{}g}", value, digits);
  // Values with more whole digits than asked for are rounded, not written with an exponent.
  if (std::abs(value) >= std::pow(10.0, digits) && std::abs(value) < 1e7)
    text = fmt::format("{:.0f}", value);
  if (text == "-0") text = "0";
  if (text[0] == '-') text = "\u2212" + text.substr(1);
  return text;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "\u2212" : "") + text;
}

std::string signed_number(double value, int digits) {
  return (value > 0 ? "+" : "") + number(value, digits);
}

std::string element(const std::string& tag, const std::string& content,
                    const std::string& css_class) {
  const std::string attribute = css_class.empty() ? "" : " class=\"" + escaped(css_class) + "\"";
  return "<" + tag + attribute + ">" + content + "</" + tag + ">\n";
}

std::string defined(const std::string& words, const std::string& term) {
  return "<a class=\"def\" href=\"#def-" + escaped(term) + "\">" + escaped(words) + "</a>";
}

void Table::add(std::vector<std::string> row, std::pair<std::string, std::string> data) {
  rows_.push_back({std::move(row), std::move(data)});
}

void Table::make_sortable(std::string name) {
  sortable_ = true;
  name_ = std::move(name);
}

std::string Table::html() const {
  std::string head, body;
  for (std::size_t i = 0; i < head_.size(); ++i) {
    const auto term = terms_.find(i);
    const auto quantity = quantities_.find(i);
    head +=
        "<th scope=\"col\"" +
        (quantity == quantities_.end() ? std::string()
                                       : " data-quantity=\"" + escaped(quantity->second) + "\"") +
        (sentences_.count(i) ? " class=\"words\">" : ">") +
        (term == terms_.end() ? escaped(head_[i]) : defined(head_[i], term->second)) + "</th>";
  }
  for (const Row& row : rows_) {
    body += "<tr" +
            (row.data.first.empty()
                 ? std::string()
                 : " data-" + row.data.first + "=\"" + escaped(row.data.second) + "\"") +
            ">";
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      body += (i == 0                ? "<th scope=\"row\">"
               : sentences_.count(i) ? "<td class=\"words\">"
                                     : "<td>") +
              escaped(row.cells[i]) + (i == 0 ? "</th>" : "</td>");
    body += "</tr>\n";
  }
  const std::string attributes =
      sortable_ ? " class=\"sortable\"" +
                      (name_.empty() ? std::string() : " data-name=\"" + escaped(name_) + "\"")
                : std::string();
  return "<div class=\"scroll\"><table" + attributes + ">\n<thead><tr>" + head +
         "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
}

}  // namespace loosefit::report
