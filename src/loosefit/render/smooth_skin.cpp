#include "loosefit/render/smooth_skin.h"

#include "loosefit/geometry/low_pass.h"
#include "loosefit/render/fill_clefts.h"

namespace loosefit::render {
namespace {

constexpr double kEdges = 0.6;  // of the spread of details, that of edges

/// How far details are spread [m]; 0: they are kept.
double spread(body::Segment segment) {
  switch (segment) {
    case body::Segment::torso:
      return 0.035;
    case body::Segment::neck:
      return 0.025;
    case body::Segment::thigh:
    case body::Segment::shank:
      return 0.030;
    case body::Segment::upper_arm:
      return 0.025;
    case body::Segment::foot:
      return 0.020;
    case body::Segment::forearm:
      return 0.018;
    default:
      return 0;
  }
}

}  // namespace

std::vector<Vec3> smooth_skin(const body::Body& body) {
  std::vector<double> spreads;
  for (const body::Segment segment : body.segment) spreads.push_back(spread(segment));
  geometry::TriangleMesh form = body.surface;
  form.vertices = geometry::low_passed(form.vertices, body.surface, spreads);
  // Nothing sticks out any more that a tape would go over; what it leaves are edges.
  form.vertices = fill_clefts(body, form);
  for (double& s : spreads) s *= kEdges;
  return geometry::low_passed(form.vertices, body.surface, spreads);
}

}  // namespace loosefit::render
