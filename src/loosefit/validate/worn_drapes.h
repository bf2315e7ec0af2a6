#pragma once
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"

// Garments on people, for the gates of docs/theory/air_gap.md: run by the study pipeline as any
// scenario is.
namespace loosefit::validate {

/// One donning of a case; refers to the case.
struct WornDrape {
  const garment::Garment& mesh;
  const fabric::Material& material;
  const body::PosedBody& body;
  const drape::Drape& drape;
  const maps::WornGarment& worn;
  const maps::PressureField& pressure;

  double half_thickness() const { return 0.5 * material.thickness; }  ///< [m]
  double weight() const { return mesh.mass * kGravity; }              ///< [N]
  /// Total normal force of the body over the garment's weight.
  double force_over_weight() const;
};

/// A person in a garment that is put on `donnings` times, at `edge` [m]. `body` and `garment` are
/// lines of these sections of a scenario file; all else has its defaults.
scenario::Scenario worn_scenario(const std::string& body, const std::string& garment, double edge,
                                 int donnings);

/// Runs it. \throws SolverFailure, naming `who`, when the reference donning does not settle or is
/// not worn.
pipeline::CaseResult wear(const scenario::Scenario& scenario, const std::string& who,
                          Progress& progress);

/// Of a garment that no study has put on. \throws SolverFailure, naming `who`, when it is not worn.
void require_worn(const garment::Garment& mesh, const pattern::Pattern& pattern,
                  const std::vector<Vec3>& positions, const body::PosedBody& body,
                  const std::string& who);

/// The donnings that settled and are worn, the reference first. Only of the reference posture.
std::vector<WornDrape> worn_drapes(const pipeline::CaseResult& result);

}  // namespace loosefit::validate
