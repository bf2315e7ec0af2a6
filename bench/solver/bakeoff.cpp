// Races of solver methods on the same drapes to the same residual; see README.md.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "outer_loop.h"
#include "problem.h"

namespace loosefit::bakeoff {
namespace {

nlohmann::ordered_json to_json(const Candidate& candidate, const Race& race) {
  nlohmann::ordered_json json{{"method", candidate.name}, {"what", candidate.what}};
  json["reason"] = race.reason;
  const Sample& last = race.samples.back();
  json["cpu_seconds"] = last.cpu;
  json["wall_seconds"] = last.wall;
  json["iterations"] = last.iterations;
  json["factorisations"] = last.factorisations;
  json["residual"] = last.residual;
  json["best_residual"] = std::ranges::min_element(race.samples, {}, [](const Sample& s) {
                            return s.residual;
                          })->residual;
  json["seconds"] = {{"assemble", race.work.assemble}, {"factorise", race.work.factorise},
                     {"solve", race.work.solve},       {"collide", race.work.collide},
                     {"evaluate", race.work.evaluate}, {"refresh", race.work.refresh}};
  auto& samples = json["samples"] = nlohmann::ordered_json::array();
  for (const Sample& s : race.samples)
    samples.push_back({s.wall, s.cpu, s.iterations, s.factorisations, s.residual});
  return json;
}

/// All of `known` whose name is in `wanted`; all when that is empty.
bool chosen(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::ranges::find(wanted, name) != wanted.end();
}

int run(int argc, char** argv) {
  RaceOptions options;
  std::string file = "bakeoff.json";
  std::vector<std::string> problems, methods, known_methods;
  for (const Candidate& c : candidates()) known_methods.push_back(c.name);
  int threads = 1;
  CLI::App app{"Races solver methods on the same drapes to the same residual"};
  app.add_option("-o,--out", file, "JSON file to write");
  app.add_option("--limit", options.cpu_limit, "processor seconds per race")
      ->check(CLI::PositiveNumber);
  app.add_option("--tolerance", options.tolerance, "residual to reach")->check(CLI::PositiveNumber);
  app.add_option("--threads", threads, "of a race")->check(CLI::Range(1, 256));
  app.add_option("--problems", problems)->check(CLI::IsMember(problem_names()));
  app.add_option("--methods", methods)->check(CLI::IsMember(known_methods));
  CLI11_PARSE(app, argc, argv);

  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  nlohmann::ordered_json all{{"tolerance", options.tolerance},
                             {"cpu_limit", options.cpu_limit},
                             {"threads", threads},
                             {"problems", nlohmann::ordered_json::array()}};
  const auto store = [&] {
    std::ofstream out(file);
    out << all.dump() << '\n';
    if (!out.flush()) throw IoError(file + ": cannot be written");
  };
  for (const std::string& name : problem_names()) {
    if (!chosen(problems, name)) continue;
    const Problem problem = make_problem(name);
    options.first_dt = problem.first_dt;
    fmt::print("{}: {}; {} vertices\n", name, problem.what, problem.vertices);
    all["problems"].push_back({{"problem", name},
                               {"what", problem.what},
                               {"vertices", problem.vertices},
                               {"races", nlohmann::ordered_json::array()}});
    for (const Candidate& candidate : candidates()) {
      if (!chosen(methods, candidate.name)) continue;
      World world = problem.make();
      const Race race = run_race(*world.system, world.x, candidate, options);
      const Sample& last = race.samples.back();
      fmt::print("  {:22} {:18} residual {:8.1e}  {:6.1f} cpu s  {:5d} iterations  {:5d} factors\n",
                 candidate.name, race.reason, last.residual, last.cpu, last.iterations,
                 last.factorisations);
      std::fflush(stdout);
      all["problems"].back()["races"].push_back(to_json(candidate, race));
      store();
    }
  }
  store();
  return 0;
}

}  // namespace
}  // namespace loosefit::bakeoff

int main(int argc, char** argv) {
  try {
    return loosefit::bakeoff::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  }
}
