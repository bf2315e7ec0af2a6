#include <fmt/format.h>

#include <algorithm>

#include "loosefit/report/html.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/ranking_output.h"
#include "loosefit/report/sections.h"
#include "loosefit/report/svg.h"

namespace loosefit::report {
namespace {

constexpr double kWidth = 640, kRow = 24, kName = 170, kRight = 16, kTop = 8, kBottom = 34;

/// Scores on a scale from 0 to 1: the robust one as a disc with its interval, the median as a bar.
std::string score_chart(const placement::RankingTable& table) {
  const auto& sites = table.ranking.sites;
  const double height = kTop + kRow * static_cast<double>(sites.size()) + kBottom;
  const double bottom = height - kBottom;
  const auto x = [](double q) { return kName + q * (kWidth - kName - kRight); };
  std::string svg = svg_open(kWidth, height, "Scores of the sites");
  for (double q : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += svg_line(x(q), kTop, x(q), bottom, "stroke=\"#e3e7eb\"") +
           svg_text(x(q), bottom + 14, "middle", fmt::format("{:g}", q));
  svg += svg_line(x(table.scorecard.pass), kTop, x(table.scorecard.pass), bottom,
                  "stroke=\"#1d6b3a\" stroke-dasharray=\"5 4\"") +
         "\n";
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const placement::RankedSite& site = sites[i];
    const double y = kTop + kRow * (static_cast<double>(i) + 0.5);
    svg += svg_text(kName - 8, y + 4, "end", escaped(site.name));
    if (!site.score.rated()) {
      svg += svg_text(x(0) + 4, y + 4, "start", "not rated");
      continue;
    }
    const char* blue = "stroke=\"#2458a8\" stroke-width=\"2\"";
    if (const auto& interval = site.robust_interval)
      svg += svg_line(x(interval->low), y, x(interval->high), y, blue) +
             svg_line(x(interval->low), y - 4, x(interval->low), y + 4, blue) +
             svg_line(x(interval->high), y - 4, x(interval->high), y + 4, blue);
    svg += svg_line(x(site.score.median), y - 8, x(site.score.median), y + 8,
                    "stroke=\"#5c6b7a\" stroke-width=\"2\"");
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"#2458a8\"/>\n",
                       x(site.score.robust), y);
  }
  return svg +
         svg_text(0.5 * (kName + kWidth), height - 6, "middle",
                  "score: disc robust with 90 % interval, upright bar median, dashed line pass") +
         "</svg>\n";
}

std::string interval_text(const std::optional<placement::Interval>& interval, int decimals) {
  return interval ? fixed(interval->low, decimals) + " … " + fixed(interval->high, decimals) : "–";
}

}  // namespace

std::string ranking_section(const placement::RankingTable* table) {
  if (!table || table->ranking.sites.empty()) return {};
  const auto& sites = table->ranking.sites;
  Table rows({"site", "mark", "rank", "score", "90 %", "median", "passing", "rank 90 %",
              "panel, u, v [mm]", "limited by"});
  rows.make_sortable("ranking");
  const char* const terms[] = {"mark",    "rank",     "robust", "interval", "robust",
                               "passing", "interval", "uv",     "limited"};
  for (std::size_t i = 0; i < std::size(terms); ++i) rows.define(i + 1, terms[i]);
  const char* const quantities[] = {"score_robust", "", "score_median"};
  for (std::size_t i = 0; i < std::size(quantities); ++i)
    if (*quantities[i]) rows.tell(i + 3, quantities[i]);
  rows.wrap(9);
  int mark = 0;
  for (const placement::RankedSite& site : sites) {
    const placement::SiteScore& score = site.score;
    const placement::RankedPlace& at = table->places[site.index];
    const std::string number = std::to_string(++mark);
    const std::string place =
        spaced(at.panel) + ", " + fixed(1e3 * at.at.x(), 0) + ", " + fixed(1e3 * at.at.y(), 0);
    if (!score.rated()) {
      rows.add({site.name, number, "–", "≤ " + fixed(score.bound, 2), "–", "–", "–", "–", place,
                score.reason},
               {"place", site.name});
      continue;
    }
    const int worst = score.robust_sample;
    const bool many = table->sample_names.size() > 1 && worst >= 0 &&
                      worst < static_cast<int>(table->sample_names.size());
    const std::string rank = rank_text(site, table->ranking);
    const std::string reason = (score.robust >= table->scorecard.pass && score.robust < 1
                                    ? "passes; nearest to its limit: "
                                    : "") +
                               score.reason;
    rows.add({site.name, number, rank == "-" ? "–" : rank, fixed(score.robust, 2),
              interval_text(site.robust_interval, 2), fixed(score.median, 2),
              fixed(100 * score.passing, 0) + " %", interval_text(site.rank_interval, 0), place,
              many ? reason + " (" + table->sample_names[worst] + ")" : reason},
             {"place", site.name});
  }
  std::string html = element("h2", "Where to put it: " + escaped(table->scorecard.title));
  if (!table->scorecard.about.empty()) html += element("p", escaped(table->scorecard.about));
  if (const std::string verdict = ranking_verdict(*table); !verdict.empty())
    html += element("p", escaped(verdict + "."), "box warn");
  html += score_chart(*table) + rows.html();
  std::string notes;
  for (const std::string& note : ranking_notes(*table)) notes += element("li", escaped(note));
  return notes.empty() ? html : html + element("ul", notes);
}

}  // namespace loosefit::report
