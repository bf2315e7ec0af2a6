#include <fmt/format.h>

#include "loosefit/validate/catalogue.h"
#include "loosefit/validate/hanging_loop.h"

namespace loosefit::validate {
namespace {

struct LoopRow {
  double gravity_number, height, half_width;  ///< Γ; over L
};
struct LoopTable {
  LoopKind kind;
  const char* name;
  std::vector<LoopRow> rows;
};

// Heavy elastica with both ends in a clamp, by shooting: docs/theory/validation.md 4.5. The
// weightless heights are the textbook constants 0.3183, 0.4243 and 0.1337 (Peirce 1930).
std::vector<LoopTable> loop_tables() {
  return {{LoopKind::ring,
           "ring",
           {{0, 0.31830989, 0.15915494},
            {1, 0.31860930, 0.15901733},
            {5, 0.31979729, 0.15846867},
            {10, 0.32126079, 0.15778684},
            {20, 0.32411771, 0.15643680},
            {50, 0.33215571, 0.15249923},
            {100, 0.34395427, 0.14632646},
            {200, 0.36272908, 0.13544180},
            {500, 0.39607779, 0.11236202}}},
          {LoopKind::pear,
           "pear",
           {{0, 0.42430805, 0.10210703},
            {1, 0.42438986, 0.10203522},
            {5, 0.42471434, 0.10174986},
            {10, 0.42511380, 0.10139736},
            {20, 0.42589289, 0.10070605},
            {50, 0.42808277, 0.09873539},
            {100, 0.43130611, 0.09575817},
            {200, 0.43652521, 0.09073157},
            {500, 0.44651183, 0.08031677}}},
          {LoopKind::heart,
           "heart",
           {{0, 0.13386037, 0.16297596},
            {1, 0.13443595, 0.16296139},
            {5, 0.13672132, 0.16289608},
            {10, 0.13954047, 0.16279917},
            {20, 0.14505715, 0.16255756},
            {50, 0.16069449, 0.16150301},
            {100, 0.18404259, 0.15892625},
            {200, 0.22238927, 0.15210960},
            {500, 0.29406537, 0.13036879},
            {1000, 0.34849036, 0.10528208}}}};
}

}  // namespace

BenchmarkResult benchmark_loops(Effort effort, Progress& progress) {
  BenchmarkResult result;
  const int elements = effort == Effort::full ? 120 : 60;
  // Index 0 is the height, 1 the half width, here and in all pairs below.
  report::Plot heights{"Hanging loops: height", "Γ = q L³/B", "height over L", false, false, {}};
  report::Plot widths{
      "Hanging loops: half width", "Γ = q L³/B", "half width over L", false, false, {}};
  std::vector<report::Plot::Series> references[2], obtained[2];
  double done = 0;
  for (const LoopTable& table : loop_tables()) {
    // One loop per shape: each gravity starts from the shape of the one before.
    HangingLoop loop(table.kind, elements);
    for (int k = 0; k < 2; ++k) {
      references[k].push_back({std::string(table.name) + ", elastica", {}, {}, true});
      obtained[k].push_back({std::string(table.name) + ", obtained", {}, {}, false});
    }
    const auto point = [](report::Plot::Series& series, double x, double y) {
      series.x.push_back(x);
      series.y.push_back(y);
    };
    // The exact curve gets all rows, a quick run settles at three of them.
    for (const LoopRow& row : table.rows) {
      const double g = row.gravity_number;
      progress.update(done / 3 + g / 3000, fmt::format("{}, Γ = {:g}", table.name, g));
      point(references[0].back(), g, row.height);
      point(references[1].back(), g, row.half_width);
      if (effort == Effort::quick && g != 0 && g != 10 && g != 100) continue;
      loop.settle(g, progress);
      // Both lengths are judged against the elastica.
      const double found[2] = {loop.height(), loop.half_width()};
      for (int k = 0; k < 2; ++k) {
        Finding f;
        f.what = fmt::format("{} {}/L at Γ = {:g}", table.name, k ? "half width" : "height", g);
        f.expected = k ? row.half_width : row.height;
        f.obtained = found[k];
        f.limit = 0.01;
        f.mesh = fmt::format("{} edges along L, {}", elements, loop.mesh());
        result.findings.push_back(f);
        point(obtained[k].back(), g, found[k]);
      }
    }
    done += 1;
  }
  // Exact curves first, marks over them.
  for (int k = 0; k < 2; ++k) {
    report::Plot& plot = k ? widths : heights;
    plot.series = references[k];
    plot.series.insert(plot.series.end(), obtained[k].begin(), obtained[k].end());
    result.plots.push_back(plot);
  }
  result.notes = {
      "A strip of 100 mm whose ends are held in one clamp and which is sewn in its middle; the "
      "ring "
      "is sewn to its clamp from both sides, a tube with real seams. Gravity is raised from zero. "
      "At "
      "rest means against the weight or the force 4π² B/L² of bending, whichever is larger.",
      "The ends of pear and heart lie 40 µm apart, two layers of 10 µm and air; half widths are "
      "counted from each end."};
  return result;
}

}  // namespace loosefit::validate
