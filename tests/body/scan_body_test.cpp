#include "loosefit/body/scan_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/scan_girths.h"
#include "loosefit/body/surface_topology.h"
#include "support/body_fixture.h"
#include "support/shapes.h"

namespace loosefit::body {
namespace {

constexpr double kAgree = 0.97;   // share of the vertices with the segment of the parametric body
constexpr double kJoint = 0.045;  // [m]

struct Person {
  double sex, age, height, chest, waist, hip;
};
constexpr std::array<Person, 2> kPeople = {
    {{0, 30, 1.68, 0.88, 0.72, 0.96}, {1, 30, 1.80, 1.00, 0.86, 1.02}}};

Body person(const Person& p) {
  BodySpec spec;
  spec.sex = p.sex, spec.age = p.age, spec.height = p.height;
  spec.measurements = {{"chest", p.chest}, {"waist", p.waist}, {"hip", p.hip}};
  const BodyFit fit = fit_body(body_model(), spec);
  return body_model().build(fit.parameters, {radians(40), 0, 0});
}

// As a scanner might store it: centimetres, y up, somewhere in the room.
geometry::TriangleMesh as_scan(const Body& body) {
  geometry::TriangleMesh mesh = body.surface;
  for (auto& p : mesh.vertices) p = Vec3(p.x(), p.z(), -p.y()) * 100 + Vec3(31, 7, -12);
  return mesh;
}

bool mentions(const std::vector<std::string>& warnings, const std::string& text) {
  for (const auto& w : warnings) {
    if (w.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(ScanBody, FindsWhatTheParametricBodyKnows) {
  for (const auto& p : kPeople) {
    const Body known = person(p);
    const ScanBody scan = body_from_scan(as_scan(known), {"scan.obj", "", ""});
    const Body& found = scan.body;
    EXPECT_TRUE(mentions(scan.warnings, "taken as cm"));
    EXPECT_TRUE(mentions(scan.warnings, "y is taken as up"));
    ASSERT_EQ(found.surface.vertices.size(), known.surface.vertices.size());

    const auto near = [&](const std::string& name, double tolerance) {
      EXPECT_NEAR(found.measured.at(name), known.measured.at(name), tolerance) << name;
    };
    near("height", 0.0005);
    near("volume", 0.0005);
    near("chest", 0.025);
    near("hip", 0.020);
    near("neck", 0.045);
    near("upper_arm", 0.015);
    near("wrist", 0.003);
    near("shoulder_breadth", 0.025);
    near("shoulder_slope", 0.06);
    near("scye_depth", 0.02);
    near("armscye", 0.03);
    near("arm_length", 0.025);
    near("armpit_level", 0.010);
    near("waist", 0.010);

    // The scan is moved to its own origin; joints are compared after the same move.
    const Vec3 move = found.surface.vertices[0] - known.surface.vertices[0];
    for (const char* joint : {"shoulder_L", "shoulder_R", "elbow_L", "elbow_R", "wrist_L",
                              "wrist_R", "hip_L", "knee_L", "ankle_R", "neck"}) {
      EXPECT_LT((found.joints.at(joint) - known.joints.at(joint) - move).norm(), 0.075) << joint;
    }
    for (const char* mark :
         {"c7", "acromion_L", "hps_R", "upper_back", "mid_back", "scapula_L", "sternum"}) {
      EXPECT_LT((found.landmarks.at(mark) - known.landmarks.at(mark) - move).norm(), 0.045) << mark;
    }
    std::size_t same = 0, arm = 0, arm_same = 0, hand_in_trunk = 0;
    for (std::size_t v = 0; v < known.segment.size(); ++v) {
      same += known.segment[v] == found.segment[v];
      // One tip of a thumb there and the trunk would be as wide as the hands are apart.
      hand_in_trunk += known.segment[v] == Segment::hand && found.segment[v] != Segment::hand &&
                       found.segment[v] != Segment::forearm;
      if (known.segment[v] == Segment::upper_arm || known.segment[v] == Segment::forearm) {
        ++arm;
        arm_same += known.segment[v] == found.segment[v] && known.side[v] == found.side[v];
      }
    }
    EXPECT_EQ(hand_in_trunk, 0u);
    EXPECT_GT(double(same), 0.92 * double(known.segment.size()));
    EXPECT_GT(double(arm_same), 0.72 * double(arm));  // elbow and wrist to a few centimetres
  }
}

TEST(ScanBody, TurnsInwardFacesAndBackwardPeople) {
  const Body known = person(kPeople[0]);
  geometry::TriangleMesh mesh = known.surface;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  for (auto& p : mesh.vertices) p = Vec3(-p.x(), -p.y(), p.z());
  const CheckedSurface checked = check_surface(mesh, {"scan.obj", "m", "z"});
  EXPECT_TRUE(mentions(checked.warnings, "turned outwards"));
  EXPECT_TRUE(mentions(checked.warnings, "180 degrees"));
  EXPECT_GT(geometry::enclosed_volume(checked.mesh), 0.05);
  EXPECT_FALSE(mentions(checked.warnings, "no units"));
}

TEST(ScanBody, RepairsMixedOrientation) {
  const Body known = person(kPeople[0]);
  geometry::TriangleMesh mesh = known.surface;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  const CheckedSurface checked = check_surface(mesh, {"scan.obj", "m", "z"});
  EXPECT_NEAR(geometry::enclosed_volume(checked.mesh), geometry::enclosed_volume(known.surface),
              1e-9);
}

// Cuts out the faces whose corners lie within `radius` of a point.
geometry::TriangleMesh with_hole(geometry::TriangleMesh mesh, const Vec3& at, double radius) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return (mesh.vertices[std::size_t(t[0])] - at).norm() < radius;
  });
  return mesh;
}

TEST(ScanBody, FillsSmallHolesAndRefusesWideOnes) {
  const Body whole = person(kPeople[0]);
  const Vec3 back = whole.landmarks.at("mid_back");
  const CheckedSurface filled =
      check_surface(with_hole(whole.surface, back, 0.015), {"hole.obj", "m", "z"});
  EXPECT_TRUE(mentions(filled.warnings, "1 small hole filled"));
  EXPECT_NEAR(geometry::enclosed_volume(filled.mesh), geometry::enclosed_volume(whole.surface),
              2e-6);
  geometry::TriangleMesh one_face = whole.surface;
  one_face.triangles.pop_back();
  EXPECT_TRUE(mentions(check_surface(one_face, {"hole.obj", "m", "z"}).warnings, "1 small hole"));
  try {
    check_surface(with_hole(whole.surface, back, 0.06), {"open.obj", "m", "z"});
    FAIL() << "an open surface was accepted";
  } catch (const GeometryError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("open.obj"), std::string::npos);
    EXPECT_NE(text.find("1 hole that is too wide"), std::string::npos) << text;
  }
}

TEST(ScanBody, RefusesASieve) {
  const Body whole = person(kPeople[0]);
  const auto with_missing_faces = [&](std::size_t count) {
    geometry::TriangleMesh mesh = whole.surface;  // one in so many, which do not touch each other
    const std::size_t step = mesh.triangles.size() / count;
    for (std::size_t i = count; i-- > 0;)
      mesh.triangles.erase(mesh.triangles.begin() + long(i * step + 7));
    return mesh;
  };
  EXPECT_TRUE(mentions(check_surface(with_missing_faces(20), {"few.obj", "m", "z"}).warnings,
                       "20 small holes filled"));
  try {
    check_surface(with_missing_faces(21), {"sieve.obj", "m", "z"});
    FAIL() << "a sieve was accepted";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("21 holes with 0."), std::string::npos)
        << error.what();
  }
}

// The arm span of somebody with level arms may be more than the height.
TEST(ScanBody, HolesAreJudgedByTheHeight) {
  const Body whole = person(kPeople[0]);
  const Vec3 back = whole.landmarks.at("mid_back");
  geometry::TriangleMesh mesh = with_hole(whole.surface, back, 0.027);
  const double width = find_holes(mesh).front().width;
  ASSERT_GT(width, 0.03 * 1.68);
  for (auto& p : mesh.vertices)  // the arms drawn out
    if (std::abs(p.x()) > 0.25) p.x() = std::copysign(0.25 + 3 * (std::abs(p.x()) - 0.25), p.x());
  EXPECT_THROW(check_surface(mesh, {"wide.obj", "m", "z"}), GeometryError);
}

TEST(ScanBody, StrayVerticesAndRepeatedFacesDoNotMatter) {
  const geometry::TriangleMesh one = person(kPeople[0]).surface;
  geometry::TriangleMesh mesh = one;
  mesh.vertices.emplace_back(0, 0, 400);
  for (std::size_t t = 0; t < 50; ++t) mesh.triangles.push_back(one.triangles[t * 7]);
  const CheckedSurface checked = check_surface(mesh, {"scan.obj", "", "z"});
  EXPECT_TRUE(mentions(checked.warnings, "50 repeated faces dropped"));
  EXPECT_EQ(checked.mesh.triangles.size(), one.triangles.size());
}

TEST(ScanBody, TellsHowTheFileWasMoved) {
  const geometry::TriangleMesh original = person(kPeople[0]).surface;
  for (const bool backwards : {false, true}) {
    geometry::TriangleMesh mesh = original;  // in a room, centimetres, y up
    const double sign = backwards ? -1 : 1;
    for (auto& p : mesh.vertices)
      p = Vec3(sign * p.x() + 0.3, p.z() - 0.95, -sign * p.y() + 0.2) * 100;
    const CheckedSurface checked = check_surface(mesh, {"scan.obj", "cm", "y"});
    for (std::size_t v = 0; v < mesh.vertices.size(); v += 997) {
      const Vec3 room =
          Vec3(mesh.vertices[v].x(), -mesh.vertices[v].z(), mesh.vertices[v].y()) / 100;
      EXPECT_LT((checked.from_world * room - checked.mesh.vertices[v]).norm(), 1e-12);
    }
    EXPECT_NEAR(checked.from_world.translation().z(), 0.95, 0.02);
  }
}

TEST(ScanBody, RefusesTwoPeopleAndDropsCrumbs) {
  const geometry::TriangleMesh one = person(kPeople[0]).surface;
  const auto add = [](geometry::TriangleMesh mesh, const geometry::TriangleMesh& other,
                      double scale, double shift) {
    const int base = int(mesh.vertices.size());
    for (const auto& p : other.vertices) mesh.vertices.push_back(scale * p + Vec3(shift, 0, 0));
    for (const auto& t : other.triangles)
      mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    return mesh;
  };
  EXPECT_THROW(check_surface(add(one, one, 1, 0.9), {"two.obj", "m", "z"}), GeometryError);
  // Mirror images 50 mm apart meet in single points, which does not make them one surface.
  EXPECT_THROW(check_surface(add(one, one, 1, 0.05), {"two.obj", "m", "z"}), GeometryError);
  const CheckedSurface checked = check_surface(add(one, one, 0.02, 0.6), {"crumb.obj", "m", "z"});
  EXPECT_EQ(checked.mesh.vertices.size(), one.vertices.size());
  EXPECT_TRUE(mentions(checked.warnings, "1 small separate piece dropped"));
}

TEST(ScanBody, RefusesAnImpossibleSize) {
  const geometry::TriangleMesh mesh = person(kPeople[0]).surface;
  EXPECT_THROW(check_surface(mesh, {"scan.obj", "mm", "z"}), InvalidInput);
  EXPECT_THROW(check_surface(mesh, {"scan.obj", "furlong", "z"}), InvalidInput);
  geometry::TriangleMesh tiny = mesh;
  for (auto& p : tiny.vertices) p *= 1e-3;
  EXPECT_THROW(check_surface(tiny, {"scan.obj", "", "z"}), InvalidInput);
}

TEST(ScanBody, GuessesInchesAndAsksAboutImplausibleHeights) {
  geometry::TriangleMesh inches = person(kPeople[0]).surface;
  for (auto& p : inches.vertices) p /= 0.0254;
  const CheckedSurface checked = check_surface(inches, {"scan.obj", "", "z"});
  EXPECT_TRUE(mentions(checked.warnings, "taken as in"));
  geometry::TriangleMesh small = person(kPeople[0]).surface;
  for (auto& p : small.vertices) p *= 0.65 / 1.68;
  try {
    check_surface(small, {"scan.obj", "", "z"});
    FAIL() << "a person of 0.65 m was believed";
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("0.65 m if these are m"), std::string::npos) << text;
    EXPECT_NE(error.hint().find("units = "), std::string::npos) << error.hint();
  }
  EXPECT_NO_THROW(check_surface(small, {"scan.obj", "m", "z"}));  // the user knows
}

// Arms close, aside, horizontal; slim, stout, small: every limb is what it is.
TEST(ScanBody, TellsLimbsApartInEveryPosture) {
  struct Case {
    Person person;
    double agree;  // least share of the vertices with the segment of the parametric body
    double joint;  // farthest that shoulders and hips are off [m]
  };
  const std::array<Case, 3> cases = {{{{0.5, 8, 1.28, 0.60, 0.54, 0.64}, 0.97, 0.030},
                                      {{1, 30, 1.80, 1.00, 0.86, 1.02}, 0.97, 0.030},
                                      {{0, 45, 1.65, 1.10, 0.98, 1.15}, 0.94, 0.080}}};
  for (const auto& [p, agree, joint_off] : cases) {
    BodySpec spec;
    spec.sex = p.sex, spec.age = p.age, spec.height = p.height;
    spec.measurements = {{"chest", p.chest}, {"waist", p.waist}, {"hip", p.hip}};
    const BodyFit fit = fit_body(body_model(), spec);
    for (const double raised : {12., 40., 90.}) {
      SCOPED_TRACE(::testing::Message() << p.height << " m, arms at " << raised);
      const Body known = body_model().build(fit.parameters, {radians(raised), 0, 0});
      const Body found = body_from_scan(as_scan(known), {"scan.obj", "", ""}).body;
      std::size_t same = 0, wrong_limb = 0;
      const auto leg = [](Segment s) { return s == Segment::shank || s == Segment::foot; };
      const auto arm = [](Segment s) { return s == Segment::forearm || s == Segment::hand; };
      for (std::size_t v = 0; v < known.segment.size(); ++v) {
        same += known.segment[v] == found.segment[v];
        wrong_limb += leg(known.segment[v]) !=
                          (leg(found.segment[v]) || found.segment[v] == Segment::thigh) &&
                      known.segment[v] != Segment::thigh && known.segment[v] != Segment::torso;
        wrong_limb += arm(known.segment[v]) && found.side[v] != known.side[v];
      }
      EXPECT_EQ(wrong_limb, 0u) << p.height << " m, arms at " << raised;
      EXPECT_GT(double(same), agree * double(known.segment.size())) << p.height << ' ' << raised;
      const Vec3 move = found.surface.vertices[0] - known.surface.vertices[0];
      for (const char* joint : {"shoulder_L", "shoulder_R", "hip_L", "hip_R"})
        EXPECT_LT((found.joints.at(joint) - known.joints.at(joint) - move).norm(), joint_off)
            << joint << ' ' << p.height << " m, arms at " << raised;
      EXPECT_NEAR(found.measured.at("upper_arm"), known.measured.at("upper_arm"), 0.03) << raised;
      EXPECT_NEAR(found.measured.at("chest"), known.measured.at("chest"), 0.040) << raised;
      EXPECT_NEAR(found.measured.at("waist"), known.measured.at("waist"), 0.015) << raised;
      EXPECT_NEAR(found.measured.at("hip"), known.measured.at("hip"), 0.025) << raised;
      EXPECT_GT(found.joints.at("hip_L").x(), 0.04);
      EXPECT_LT(found.joints.at("hip_R").x(), -0.04);
    }
  }
}

// Shirts are drafted for hanging arms, however the arms were held in the scanner.
TEST(ScanBody, DepthOfTheArmholeIsThatOfHangingArms) {
  for (const double height : {1.35, 1.68}) {
    BodySpec spec;
    spec.age = height < 1.5 ? 9 : 30, spec.height = height;
    const BodyFit fit = fit_body(body_model(), spec);
    for (const double raised : {25., 41., 55., 70., 90.}) {
      const Body known = body_model().build(fit.parameters, {radians(raised), 0, 0});
      const Body found = body_from_scan(as_scan(known), {"scan.obj", "", ""}).body;
      EXPECT_NEAR(found.measured.at("scye_depth"), known.measured.at("scye_depth"), 0.02)
          << height << ' ' << raised;
    }
  }
}

// The section in the joint's plane of a stout person runs down the side of the trunk: 0.31 m deep
// and 0.78 m round on this man, whom no shirt of such armholes would let lift an arm.
TEST(ScanBody, ArmholesOfStoutPeopleAreAsDeepAsTailorsMakeThem) {
  for (const Person& p :
       {Person{1, 50, 1.76, 1.16, 1.10, 1.14}, Person{0, 70, 1.60, 1.04, 0.94, 1.08},
        Person{1, 35, 1.78, 1.00, 0.88, 1.02}, Person{0, 30, 1.68, 0.96, 0.8, 1.02}}) {
    const Body body = person(p);
    EXPECT_GT(body.measured.at("scye_depth"), 0.085 * p.height) << p.chest;
    EXPECT_LT(body.measured.at("scye_depth"), 0.125 * p.height) << p.chest;
    EXPECT_GT(body.measured.at("armscye"), 0.37 * p.chest) << p.chest;
    EXPECT_LT(body.measured.at("armscye"), 0.48 * p.chest) << p.chest;
  }
}

// On a belly the narrowest level lies above or below the waist.
TEST(ScanBody, TapesTheWaistWhereTheParametricBodyHasIt) {
  for (const Person& p :
       {Person{1, 50, 1.76, 1.15, 1.12, 1.15}, Person{1, 70, 1.70, 1.02, 1, 1},
        Person{0, 60, 1.60, 1.05, 1.00, 1.08}, Person{0, 25, 1.70, 0.80, 0.62, 0.86}}) {
    const Body known = person(p);
    const ScanBody scan = body_from_scan(as_scan(known), {"scan.obj", "cm", "y"});
    const auto near = [&](const char* name, double tolerance) {
      EXPECT_NEAR(scan.body.measured.at(name), known.measured.at(name), tolerance)
          << name << ' ' << p.waist;
    };
    near("chest", 0.030);
    near("waist", 0.015);
    near("hip", 0.030);
    near("waist_level", 0.008 * p.height);
    near("hps_to_waist", 0.035);
    EXPECT_FALSE(mentions(scan.warnings, "more than the trunk"));
  }
}

/// The left hand grown together with the hip by a bridge between two faces at the height of `z`.
geometry::TriangleMesh with_grown_hand(const Body& body, double z) {
  geometry::TriangleMesh mesh = body.surface;
  const auto middle = [&](const Triangle& t) {
    return Vec3((mesh.vertices[std::size_t(t[0])] + mesh.vertices[std::size_t(t[1])] +
                 mesh.vertices[std::size_t(t[2])]) /
                3);
  };
  std::size_t from = 0, to = 0;
  double nearest = 1;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto v = std::size_t(mesh.triangles[i][0]);
    const Vec3 p = middle(mesh.triangles[i]);
    if (body.side[v] <= 0 || std::abs(p.z() - z) > 0.01 ||
        (body.segment[v] != Segment::hand && body.segment[v] != Segment::forearm))
      continue;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      const auto w = std::size_t(mesh.triangles[k][0]);
      if (body.segment[w] != Segment::torso && body.segment[w] != Segment::thigh) continue;
      const Vec3 q = middle(mesh.triangles[k]);
      if (std::abs(p.z() - q.z()) > 0.001) continue;  // a level cut goes along the bridge
      const double d = (q - p).norm();
      if (d < nearest) nearest = d, from = i, to = k;
    }
  }
  const Triangle a = mesh.triangles[from], b = mesh.triangles[to];
  const auto length = [&](std::size_t shift) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += (mesh.vertices[std::size_t(a[i])] - mesh.vertices[std::size_t(b[(shift + 3 - i) % 3])])
                 .norm();
    return sum;
  };
  std::size_t shift = 0;
  for (const std::size_t s : {std::size_t(1), std::size_t(2)})
    if (length(s) < length(shift)) shift = s;
  for (std::size_t i = 0; i < 3; ++i) {
    const int a0 = a[i], a1 = a[(i + 1) % 3];
    const int b0 = b[(shift + 3 - i) % 3], b1 = b[(shift + 5 - i) % 3];
    mesh.triangles.push_back({a0, a1, b1});
    mesh.triangles.push_back({a0, b1, b0});
  }
  std::erase(mesh.triangles, a);
  std::erase(mesh.triangles, b);
  return mesh;
}

TEST(ScanBody, AHandGrownToTheHipIsNotTaped) {
  BodySpec spec;
  spec.sex = 1, spec.age = 30, spec.height = 1.80;
  spec.measurements = {{"chest", 1.0}, {"waist", 0.86}, {"hip", 1.02}};
  const Body known =
      body_model().build(fit_body(body_model(), spec).parameters, {radians(18), 0, 0});
  const double apart = body_from_scan(known.surface, {"scan.obj", "m", "z"}).body.measured["hip"];
  const geometry::TriangleMesh mesh = with_grown_hand(known, known.measured.at("hip_level"));
  ScanBody grown = body_from_scan(mesh, {"scan.obj", "m", "z"});
  EXPECT_TRUE(mentions(grown.warnings, "left hand has grown together"));
  EXPECT_NEAR(grown.body.measured.at("hip"), apart, 0.02);
  EXPECT_NEAR(grown.body.measured.at("waist"), known.measured.at("waist"), 0.015);

  // The same hand, had nobody told it from the hip.
  const ScanSections sections =
      slice_scan(grown.body.surface, find_limbs(grown.body.surface, 1.80));
  std::fill(grown.body.segment.begin(), grown.body.segment.end(), Segment::torso);
  std::vector<std::string> warnings;
  try {
    tape_trunk(sections, grown.body, warnings);
    FAIL() << "a hip with a hand was believed";
  } catch (const GeometryError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("a hip of"), std::string::npos) << text;
    EXPECT_NE(text.find("more than the trunk"), std::string::npos) << text;
  }
}

TEST(ScanBody, SaysWhatKeepsAnArmFromBeingFound) {
  const Body known = person(kPeople[0]);
  geometry::TriangleMesh mesh = known.surface;  // the left arm drawn into the trunk
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (known.side[v] > 0 && known.segment[v] != Segment::thigh &&
        known.segment[v] != Segment::shank && known.segment[v] != Segment::foot)
      mesh.vertices[v] =
          known.joints.at("shoulder_L") + 0.02 * (mesh.vertices[v] - known.joints.at("shoulder_L"));
  try {
    body_from_scan(mesh, {"one-arm.obj", "m", "z"});
    FAIL() << "a scan without a left arm was accepted";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("no left arm"), std::string::npos) << error.what();
    EXPECT_NE(error.hint().find("scan the person"), std::string::npos);
  }
}

TEST(ScanBody, AThingWithoutLimbsIsNamed) {
  for (const double height : {1.4, 1.7, 2.0})
    for (const double waist : {0.0, 0.3}) {  // by how much a dress form is drawn in there
      geometry::TriangleMesh form = support::sphere(1, 40, 48);
      for (Vec3& p : form.vertices) {
        const double narrow = 1 - waist * std::exp(-20 * p.z() * p.z());
        p = Vec3(0.2 * narrow * p.x(), 0.13 * narrow * p.y(), height / 2 * (1 + p.z()));
      }
      try {
        body_from_scan(form, {"form.obj", "m", "z"});
        FAIL() << "a form without limbs was accepted";
      } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("without arms and legs"), std::string::npos)
            << error.what();
        EXPECT_NE(error.hint().find("from the measures"), std::string::npos);
      }
    }
}

}  // namespace
}  // namespace loosefit::body
