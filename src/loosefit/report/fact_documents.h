#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/kinds/kind.h"
#include "loosefit/pipeline/make_garment_pattern.h"
#include "loosefit/scenario/material_card.h"

// What commands without a drape say with `--json`; keys in docs/command-line.md, units in their
// names. `files` are those that were written, relative to `folder`, which is empty when none were.
namespace loosefit::report {

struct WrittenFiles {
  std::string folder;
  std::vector<std::string> files;
};

std::string body_document(const body::Body& body, const body::BodyFit& fit,
                          const WrittenFiles& written);
std::string pattern_document(const pipeline::GarmentPattern& made, const WrittenFiles& written);
std::string sizes_document(const kinds::GarmentKind& kind);
/// All cards that are shipped.
std::string materials_document();
std::string material_document(const scenario::MaterialCard& card);
std::string versions_document();

/// One check of `loosefit doctor`.
struct Finding {
  std::string what;
  bool ok = false;
  std::string found, hint;
};
std::string doctor_document(const std::vector<Finding>& findings, bool can_run);

/// Whether a scenario file would be taken, and if not, the error of it.
struct CheckedScenario {
  std::string file;
  std::string error;  ///< a document of error_document; empty: taken
};
std::string checked_document(const std::vector<CheckedScenario>& checked);

}  // namespace loosefit::report
