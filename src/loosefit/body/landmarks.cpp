#include "loosefit/body/landmarks.h"

#include <cmath>
#include <limits>

#include "loosefit/body/rulers.h"

namespace loosefit::body {
namespace {

const std::map<std::string, int> kMiddle = {
    {"crown", 881},        {"c7", 1491},         {"back_waist", 4181},
    {"front_waist", 4121}, {"crotch", 4372},     {"upper_back", 1597},
    {"mid_back", 3946},    {"lower_back", 4030}, {"neck_pit", 1522},
};

// Left vertex; the right one is its mirror image.
const std::map<std::string, int> kPairs = {
    {"hps", 7539},    {"acromion", 8274},     {"nipple", 8451},  {"elbow", 10037},
    {"wrist", 10548}, {"armpit_front", 8125}, {"scapula", 8246}, {"scapula_lower", 10592},
};

// The foremost vertex of the mid-sagittal line at a height: breast bone, pit of the neck.
int front_middle(const BodyData& data, const RestBody& rest, double z) {
  int best = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (int v = 0; v < data.body_vertices; ++v) {
    const Vec3& p = rest.surface.vertices[std::size_t(v)];
    if (data.mirror[std::size_t(v)] != v || p.y() > rest.surface.vertices[1491].y()) continue;
    // Depth decides among the front and the pockets behind it.
    const double miss = std::abs(p.z() - z) + 0.1 * p.y();
    if (miss < nearest) nearest = miss, best = v;
  }
  return best;
}

}  // namespace

std::map<std::string, int> landmark_vertices(const BodyData& data, const RestBody& rest) {
  std::map<std::string, int> found = kMiddle;
  for (const auto& [name, left] : kPairs) {
    found[name + "_L"] = left;
    found[name + "_R"] = data.mirror[std::size_t(left)];
  }
  found["sternum"] = front_middle(data, rest, ruler_centre(rest.surface.vertices, "bust_circ").z());
  return found;
}

std::map<std::string, int> joint_indices(const BodyData& data) {
  const auto head = [&](const std::string& bone) {
    return data.bones[std::size_t(data.bone(bone))].head;
  };
  std::map<std::string, int> joints = {
      {"neck", head("neck01")}, {"head", head("head")}, {"pelvis", head("spine05")}};
  for (int i = 1; i <= 5; ++i)
    joints["spine_" + std::to_string(i)] = head("spine0" + std::to_string(i));
  for (const char* side : {"L", "R"}) {
    const std::string dot = std::string(".") + side, under = std::string("_") + side;
    joints["clavicle" + under] = head("clavicle" + dot);
    joints["shoulder" + under] = head("upperarm01" + dot);
    joints["elbow" + under] = head("lowerarm01" + dot);
    joints["wrist" + under] = head("wrist" + dot);
    joints["hand" + under] = data.bones[std::size_t(data.bone("wrist" + dot))].tail;
    joints["hip" + under] = head("upperleg01" + dot);
    joints["knee" + under] = head("lowerleg01" + dot);
    joints["ankle" + under] = head("foot" + dot);
  }
  return joints;
}

const std::vector<int>& back_line() {
  static const std::vector<int> kLine = {
      853,  854,  855,  856,  857,  858,  1496, 1491, 1467, 1539, 1550, 1595, 1596, 1597,
      3780, 3843, 1598, 1599, 1600, 3932, 3946, 3960, 3974, 3988, 4002, 4016, 4030, 4045,
      4148, 4060, 4181, 4188, 4195, 4387, 4205, 4215, 4223, 4232, 4241, 4250, 4259};
  return kLine;
}

}  // namespace loosefit::body
