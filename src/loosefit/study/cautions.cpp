#include "loosefit/study/cautions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

#include "loosefit/placement/metric_names.h"
#include "loosefit/report/html.h"
#include "loosefit/study/unit_words.h"

namespace loosefit::study {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Where the figure ends that begins at `at`.
std::size_t figure_end(const std::string& text, std::size_t at) {
  const auto digits = [&](std::size_t from) {
    while (from < text.size() && is_digit(text[from])) ++from;
    return from;
  };
  std::size_t end = digits(at);
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) end = digits(end + 1);
  if (end + 1 < text.size() && text[end] == 'e') {
    const std::size_t sign = end + 1 + (text[end + 1] == '-' || text[end + 1] == '+');
    if (const std::size_t exponent = digits(sign); exponent > sign) end = exponent;
  }
  return end;
}

std::string leading_words(const std::string& text) {
  std::istringstream words(without_figures(text));
  std::string lead, word;
  for (int i = 0; i < kLeadingWords && words >> word; ++i) lead += word + " ";
  return lead;
}

std::string caution_list(const std::vector<Caution>& cautions, std::size_t from, std::size_t to,
                         int ran) {
  std::string list;
  for (std::size_t i = from; i < to; ++i)
    list += report::element(
        "li", fmt::format("<strong>in {} of {}</strong>, as in case {}: {}", cautions[i].cases,
                          counted(ran, "case", "cases"), cautions[i].number,
                          report::escaped(cautions[i].example)));
  return report::element("ul", list);
}

}  // namespace

std::string without_figures(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const bool begins = at == 0 || !is_of_word(text[at - 1]);
    const std::size_t first = at + (begins && (text[at] == '-' || text[at] == '+'));
    if (begins && first < text.size() && is_digit(text[first])) {
      out += '#';
      at = figure_end(text, first);
    } else {
      out += text[at++];
    }
  }
  return out;
}

std::string metrics_in_words(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_of_word(text[end])) ++end;
    if (end == at) {
      out += text[at++];
      continue;
    }
    const std::string word = text.substr(at, end - at);
    // "strain" is a word of the language, too.
    const placement::MetricName* metric =
        word.find('_') == std::string::npos ? nullptr : placement::find_metric(word);
    out += metric ? metric->words : word;
    at = end;
  }
  return out;
}

std::vector<Caution> group_warnings(const StudyData& data) {
  std::map<std::string, std::size_t> by_lead;
  std::vector<Caution> cautions;
  for (std::size_t c = 0; c < data.warnings.size(); ++c) {
    std::set<std::size_t> of_case;
    for (const std::string& warning : data.warnings[c]) {
      const auto [group, is_new] = by_lead.try_emplace(leading_words(warning), cautions.size());
      if (is_new) cautions.push_back({metrics_in_words(warning), data.plan.cases[c].number, 0});
      of_case.insert(group->second);
    }
    for (const std::size_t group : of_case) ++cautions[group].cases;
  }
  std::ranges::stable_sort(cautions, std::ranges::greater{}, &Caution::cases);
  return cautions;
}

int warned_cases(const StudyData& data) {
  return static_cast<int>(std::ranges::count_if(
      data.warnings, [](const std::vector<std::string>& warnings) { return !warnings.empty(); }));
}

std::string cautions_in_words(const StudyData& data) {
  const int warned = warned_cases(data);
  if (warned == 0) return {};
  return fmt::format("{} of {} {} warnings: see Cautions on the page", warned,
                     counted(data.ran, "case", "cases"), warned == 1 ? "carries" : "carry");
}

std::string cautions_html(const StudyData& data) {
  const std::vector<Caution> cautions = group_warnings(data);
  if (cautions.empty()) return {};
  const std::size_t shown = std::min(cautions.size(), kOpenCautions);
  std::string html = report::element("h2", "Cautions") +
                     report::element("p",
                                     "What the cases warn of, each kind with the figures of one "
                                     "case; all of them stand in the table notes of the database.",
                                     "lead") +
                     caution_list(cautions, 0, shown, data.ran);
  if (shown < cautions.size())
    html += "<details><summary>" +
            report::escaped(fmt::format("{} more", cautions.size() - shown)) + "</summary>" +
            caution_list(cautions, shown, cautions.size(), data.ran) + "</details>\n";
  return html;
}

}  // namespace loosefit::study
