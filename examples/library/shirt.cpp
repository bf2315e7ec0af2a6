// Drapes the scenario of a file and prints how far its cloth is from the body.
#include <loosefit/loosefit.h>

#include <algorithm>
#include <cstdio>

int main(int count, char** arguments) try {
  if (count > 2) loosefit::use_data_folder(arguments[2]);  // else where it is usually found
  const loosefit::library::Outcome outcome = loosefit::library::run(arguments[1]);
  const loosefit::library::Garment& shirt = outcome.studied();
  std::printf("%zu vertices, residual %.1e, %s\n", shirt.surface.vertices.size(),
              outcome.verdict.residual, outcome.verdict.holds ? "holds" : "does not hold");
  if (const auto* map = shirt.find_map("distance_mm"))
    std::printf("largest distance from the body: %.17g %s\n",
                *std::max_element(map->values.begin(), map->values.end()), map->unit.c_str());
  return outcome.verdict.holds ? 0 : 1;
} catch (const loosefit::Error& error) {
  std::fprintf(stderr, "error: %s\nhint: %s\n", error.what(), error.hint().c_str());
  return 2;
}
