#include "loosefit/validate/air_gap_cells.h"

#include <algorithm>
#include <cmath>

#include "loosefit/validate/correlation.h"

namespace loosefit::validate {
namespace {

constexpr double kLeastRank = 0.7, kLeastInside = 0.8;
constexpr double kMostGapBias = 5, kMostContactBias = 15;  ///< [mm], [points]
constexpr std::size_t kEnoughForRanks = 4;

}  // namespace

std::vector<Finding> judge_cells(const std::vector<AirGapCell>& cells, const std::string& mesh) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const AirGapCell& cell : cells)
    if (const std::pair key(cell.source, cell.quantity);
        std::find(groups.begin(), groups.end(), key) == groups.end())
      groups.push_back(key);
  std::vector<Finding> findings;
  for (const auto& [source, quantity] : groups) {
    std::vector<double> published, draped;
    double bias = 0;
    int told = 0, inside = 0;
    std::string unit;
    for (const AirGapCell& cell : cells) {
      if (cell.source != source || cell.quantity != quantity) continue;
      published.push_back(cell.published), draped.push_back(cell.draped);
      bias += cell.draped - cell.published;
      unit = cell.unit;
      if (!(cell.deviation > 0)) continue;
      ++told;
      inside += std::abs(cell.draped - cell.published) <= 2 * cell.deviation;
    }
    const auto add = [&](const std::string& what, const std::string& in, double expected,
                         double obtained, double low, double high) {
      findings.push_back(in_range(source + ", " + quantity + ": " + what, in, expected, obtained,
                                  low, high, mesh));
    };
    if (published.size() >= kEnoughForRanks)
      add("rank correlation over the regions", "", 1, rank_correlation(published, draped),
          kLeastRank, 1);
    if (told > 0)
      add("share of cells within two deviations", "", 0.95, double(inside) / told, kLeastInside, 1);
    const double most = quantity == "gap" ? kMostGapBias : kMostContactBias;
    add("mean difference", unit, 0, bias / static_cast<double>(published.size()), -most, most);
  }
  return findings;
}

}  // namespace loosefit::validate
