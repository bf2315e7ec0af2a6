// Bakes the body data once at set-up: repairs lopsided targets, drops what garments do not need.
#include <cstdio>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/body/raw_body_data.h"

int main(int argc, char** argv) {
  using namespace loosefit;
  try {
    if (argc == 3 && std::string(argv[1]) == "--check") {
      body::read_body_data(argv[2]);
      return 0;
    }
    if (argc != 3) {
      std::fprintf(stderr,
                   "usage: loosefit_bake RAW_FOLDER OUT.lfb\n"
                   "       loosefit_bake --check FILE.lfb\n");
      return 2;
    }
    const body::BodyData data = body::bake_body_data(argv[1]);
    body::write_body_data(argv[2], data);
    std::printf("body data: %zu targets (%zu distinct) baked into %s\n", data.field_of_name.size(),
                data.fields.size(), argv[2]);
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    if (!error.hint().empty()) std::fprintf(stderr, "hint: %s\n", error.hint().c_str());
  } catch (const std::exception& error) {  // a key that the JSON files should have
    std::fprintf(stderr, "error: %s: %s\nhint: run: loosefit setup\n", argv[1], error.what());
  }
  return 2;
}
