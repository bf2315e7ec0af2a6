#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/scan_body.h"
#include "loosefit/body/scan_person.h"
#include "support/body_fixture.h"

// Scans of parametric people, whose measures are known.
namespace loosefit::support {

inline constexpr double kTape = 0.010;  ///< what a scan may differ by from its parametric twin [m]

inline body::BodyParameters person(double sex, double age, double height, double chest,
                                   double waist, double hip) {
  body::BodySpec spec;
  spec.sex = sex, spec.age = age, spec.height = height;
  spec.measurements = {{"chest", chest}, {"waist", waist}, {"hip", hip}};
  return body::fit_body(body_model(), spec).parameters;
}

/// As a scanner stores it: centimetres, y up, somewhere in the room, every triangle begun
/// elsewhere.
inline geometry::TriangleMesh as_scan(geometry::TriangleMesh mesh) {
  for (auto& p : mesh.vertices) p = Vec3(p.x(), p.z(), -p.y()) * 100 + Vec3(31, 7, -12);
  std::ranges::reverse(mesh.triangles);
  for (auto& t : mesh.triangles) std::ranges::rotate(t, t.begin() + 1);
  return mesh;
}

struct ScanVerdict {
  std::map<std::string, double> measured;  ///< empty if refused
  std::string reason;                      ///< why it was refused
  std::vector<std::string> warnings;
};

/// What a scenario makes of a scan: a person of the model, else a body of the surface alone, else
/// an error.
inline ScanVerdict read_scan(const geometry::TriangleMesh& scan) {
  const body::ScanOptions options{"scan.obj", "cm", "y"};
  try {
    if (const auto found = body::person_from_scan(body_model(), scan, options))
      return {found->body.measured, "", found->warnings};
    const body::ScanBody body = body::body_from_scan(scan, options);
    return {body.body.measured, "", body.warnings};
  } catch (const InvalidInput& error) {
    return {{}, error.what(), {}};
  }
}

}  // namespace loosefit::support
