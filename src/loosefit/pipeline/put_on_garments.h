#pragma once
#include <memory>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Garments that have been put on and worn in.
struct PutOn {
  std::shared_ptr<drape::DrapeSession> session;  ///< which can follow the body from here
  std::vector<drape::Drape> drapes;              ///< one per garment; worn or not is not judged yet
};

/// One donning: puts the garments on a body, as `how` says, which replaces start_shift and
/// start_twist of the options. The body is left as by put_on (case_body.h). Refers to the garments'
/// meshes. \throws as put_on.
PutOn put_on_garments(const scenario::Scenario& scenario, const std::vector<CaseGarment>& garments,
                      CaseBody& body, const CaseDonning& how, drape::DrapeOptions options,
                      Progress& progress);

}  // namespace loosefit::pipeline
