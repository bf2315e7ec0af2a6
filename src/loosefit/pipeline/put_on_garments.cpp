#include "loosefit/pipeline/put_on_garments.h"

#include "loosefit/pipeline/garment_layers.h"

namespace loosefit::pipeline {

PutOn put_on_garments(const scenario::Scenario& scenario, const std::vector<CaseGarment>& garments,
                      CaseBody& body, const CaseDonning& how, drape::DrapeOptions options,
                      Progress& progress) {
  options.start_shift = how.shift;
  options.start_twist = how.twist;
  PutOn worn;
  worn.session = std::make_shared<drape::DrapeSession>(
      cloth_layers(scenario, garments, how.friction), options, progress);
  const drape::Drape all = put_on(*worn.session, body, how.movements, &scenario);
  worn.drapes = split_drape(all, scenario, garments);
  return worn;
}

}  // namespace loosefit::pipeline
