#include "loosefit/body/raw_body_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"

namespace loosefit::body {
namespace {

using nlohmann::json;

constexpr std::size_t kVertices = 19158;
constexpr std::size_t kFaces = 18486;
constexpr std::size_t kBodyFaces = 13378;
constexpr int kBodyVertices = 13380;
constexpr int kLastMarker = 14597;  // corner of the last joint cube that bones use
constexpr std::size_t kTargets = 1258;
constexpr std::size_t kBlockBytes = kVertices * 3 * sizeof(std::int16_t);
constexpr const char* kHint = "run: loosefit setup (fetches the files and verifies them)";

std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path + ": cannot read", kHint);
  return std::string((std::istreambuf_iterator<char>(file)), {});
}

json read_json(const std::string& path) {
  json document = json::parse(slurp(path), nullptr, false);
  if (document.is_discarded()) throw IoError(path + ": found no JSON document", kHint);
  return document;
}

void require(bool good, const std::string& path, const std::string& key, const std::string& found,
             const std::string& expected) {
  if (!good) throw InvalidInput({path, 0, key}, found, expected, kHint);
}

// Every face record of this file is: 11, four corners, material, four texture corners.
std::vector<std::array<int, 4>> read_faces(const json& mesh, const std::string& path) {
  const auto flat = mesh.at("faces").get<std::vector<int>>();
  require(flat.size() == kFaces * 10, path, "faces", std::to_string(flat.size()) + " numbers",
          std::to_string(kFaces * 10));
  std::vector<std::array<int, 4>> faces;
  for (std::size_t f = 0; f < kFaces; ++f) {
    const int* record = flat.data() + 10 * f;
    const bool body = record[5] == 0;
    require(record[0] == 11 && body == (f < kBodyFaces), path, fmt::format("faces[{}]", f),
            fmt::format("mask {}, material {}", record[0], record[5]),
            "mask 11, material 0 for the first 13378 faces only");
    for (int c = 1; c <= 4; ++c) {
      require(record[c] >= 0 && record[c] < (body ? kBodyVertices : int(kVertices)), path,
              fmt::format("faces[{}]", f), fmt::format("corner {}", record[c]), "a vertex index");
    }
    faces.push_back({record[1], record[2], record[3], record[4]});
  }
  return faces;
}

std::vector<int> mirror_map(const std::vector<std::array<std::int32_t, 3>>& base,
                            const std::string& path) {
  std::map<std::array<std::int32_t, 3>, int> at;
  for (std::size_t v = 0; v < base.size(); ++v) at.emplace(base[v], int(v));
  std::vector<int> mirror;
  for (const auto& p : base) {
    const auto found = at.find({-p[0], p[1], p[2]});
    require(found != at.end() && at.size() == base.size(), path, "vertices", "a lopsided mesh",
            "one mirror image per vertex");
    mirror.push_back(found->second);
  }
  return mirror;
}

std::string group_of(const std::string& name) { return name.substr(0, name.find('/')); }

bool right_half_is_good(const std::string& name) {
  static const std::set<std::string> kNames = {"measure/measure-hips-decrease",
                                               "measure/measure-hips-increase",
                                               "measure/measure-upperlegheight-decrease",
                                               "measure/measure-waisttohip-decrease",
                                               "torso/torso-scale-depth-decr",
                                               "torso/torso-scale-depth-incr",
                                               "torso/torso-scale-vert-incr"};
  return kNames.contains(name);
}

bool one_sided_on_purpose(const std::string& name) {
  static const std::set<std::string> kNames = {
      "torso/torso-trans-horiz-in", "torso/torso-trans-horiz-out", "hip/hip-trans-in",
      "hip/hip-trans-out",          "neck/neck-trans-horiz-in",    "neck/neck-trans-horiz-out"};
  return kNames.contains(name);
}

const std::set<std::string>& symmetric_groups() {
  static const std::set<std::string> kGroups = {"macrodetails", "breast",  "measure", "torso",
                                                "hip",          "stomach", "pelvis",  "buttocks",
                                                "neck",         "legs"};
  return kGroups;
}

bool is_used(const std::string& name) {
  if (symmetric_groups().contains(group_of(name))) return true;
  return group_of(name) == "armslegs" && name.find("-hand-") == std::string::npos &&
         name.find("-foot-") == std::string::npos;
}

// Rows of the baked data: body vertices, tongue, joint markers; the helper geometry behind is
// dropped.
int row_of(int vertex) { return vertex <= kLastMarker ? vertex : -1; }

// (x, y, z) y up, z forward → (x, -z, y) z up.
template <class T>
std::array<T, 3> turned(const std::array<T, 3>& p) {
  return {p[0], T(-p[2]), p[1]};
}

BodyField field_of(const TargetBlock& block) {
  BodyField field;
  for (int v = 0; v < int(kVertices); ++v) {
    const int row = row_of(v);
    const auto& shift = block[std::size_t(v)];
    if (row < 0 || shift == std::array<std::int16_t, 3>{}) continue;
    field.rows.push_back(std::uint16_t(row));
    field.shift.push_back(turned(shift));
  }
  return field;
}

void add_skeleton(const std::string& folder, const json& mesh, BodyData& data) {
  const std::string path = folder + "/default.json";
  const json rig = read_json(path);
  std::map<std::vector<int>, int> joint_of_rows;
  const auto joint = [&](const std::string& name) {
    std::vector<int> rows;
    for (const int vertex : rig.at("joints").at(name).get<std::vector<int>>()) {
      rows.push_back(row_of(vertex));
      require(rows.back() >= 0, path, name, std::to_string(vertex), "a body or marker vertex");
    }
    const auto [found, added] = joint_of_rows.emplace(rows, int(data.joints.size()));
    if (added) data.joints.push_back(rows);
    return found->second;
  };

  // Odd entries of the mesh file's bones are the bones in the order the skin indices use (index /
  // 2).
  std::map<std::string, int> number;
  const json& twice = mesh.at("bones");
  for (std::size_t i = 1; i < twice.size(); i += 2) {
    Bone bone;
    bone.name = twice[i].at("name").get<std::string>();
    const json& entry = rig.at("bones").at(bone.name);
    bone.head = joint(entry.at("head").get<std::string>());
    bone.tail = joint(entry.at("tail").get<std::string>());
    if (!entry.at("parent").is_null()) {
      const auto parent = number.find(entry.at("parent").get<std::string>());
      require(parent != number.end(), path, bone.name, "a parent that follows it", "parents first");
      bone.parent = parent->second;
    }
    number.emplace(bone.name, int(data.bones.size()));
    data.bones.push_back(bone);
  }
}

int mirror_bone(const BodyData& data, int bone) {
  std::string name = data.bones[std::size_t(bone)].name;
  if (name.ends_with(".L")) {
    name.back() = 'R';
  } else if (name.ends_with(".R")) {
    name.back() = 'L';
  } else {
    return bone;
  }
  return data.bone(name);
}

// The weights of the package are lopsided (up to 0.26) and cut to four: average with the mirror
// image.
void add_skin(const json& mesh, BodyData& data) {
  const auto index = mesh.at("skinIndices").get<std::vector<int>>();
  const auto weight = mesh.at("skinWeights").get<std::vector<double>>();
  std::vector<int> mirrored_bone;
  for (int b = 0; b < int(data.bones.size()); ++b) mirrored_bone.push_back(mirror_bone(data, b));

  constexpr std::size_t kKeep = 6;
  for (int v = 0; v < data.body_vertices; ++v) {
    std::map<int, double> sum;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t here = 4 * std::size_t(v) + k;
      const std::size_t there = 4 * std::size_t(data.mirror[std::size_t(v)]) + k;
      sum[index.at(here) / 2] += 0.5 * weight.at(here);
      sum[mirrored_bone.at(std::size_t(index.at(there) / 2))] += 0.5 * weight.at(there);
    }
    std::vector<std::pair<int, double>> largest(sum.begin(), sum.end());
    std::erase_if(largest, [](const auto& entry) { return entry.second <= 0; });
    // Ties must not depend on bone numbers, or left and right would keep different bones.
    std::stable_sort(largest.begin(), largest.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::size_t keep = std::min(kKeep, largest.size());
    while (keep < largest.size() && keep > 1 && largest[keep].second == largest[keep - 1].second)
      --keep;
    largest.resize(keep);
    double total = 0;
    for (const auto& entry : largest) total += entry.second;
    for (auto& entry : largest) entry.second /= total;
    data.skin.push_back(std::move(largest));
  }
}

}  // namespace

RawBodyData read_raw_body_data(const std::string& folder) {
  RawBodyData raw;
  // The mesh in units of 10 µm, so that equal means equal.
  const std::string mesh_path = folder + "/human_full_size.json";
  const json mesh = read_json(mesh_path);
  const auto flat = mesh.at("vertices").get<std::vector<double>>();
  require(flat.size() == 3 * kVertices, mesh_path, "vertices",
          std::to_string(flat.size()) + " numbers", std::to_string(3 * kVertices));
  for (std::size_t i = 0; i < flat.size(); i += 3) {
    raw.base.push_back({std::int32_t(std::lround(flat[i] * 1e4)),
                        std::int32_t(std::lround(flat[i + 1] * 1e4)),
                        std::int32_t(std::lround(flat[i + 2] * 1e4))});
  }
  raw.faces = read_faces(mesh, mesh_path);
  raw.mirror = mirror_map(raw.base, mesh_path);

  // Names of the targets in the order of their blocks.
  const std::string list_path = folder + "/target-list.json";
  const json list = read_json(list_path);
  std::vector<std::string> keys;
  for (const auto& [key, tags] : list.at("targets").items()) keys.push_back(key);
  std::sort(keys.begin(), keys.end());  // with the suffix on: '.' and '-' compare differently
  require(keys.size() == kTargets, list_path, "targets", std::to_string(keys.size()) + " names",
          std::to_string(kTargets));
  const std::string prefix = "data/targets/", suffix = ".target";
  for (const auto& key : keys) {
    require(key.starts_with(prefix) && key.ends_with(suffix), list_path, "targets", key,
            prefix + "…" + suffix);
    raw.target_names.push_back(
        key.substr(prefix.size(), key.size() - prefix.size() - suffix.size()));
  }

  // The blocks themselves are read one by one; here only their size and digest.
  raw.targets_path = folder + "/targets.bin";
  const std::string blocks = slurp(raw.targets_path);
  require(blocks.size() == kTargets * kBlockBytes, raw.targets_path, "size",
          std::to_string(blocks.size()) + " bytes", std::to_string(kTargets * kBlockBytes));
  raw.targets_sha256 = sha256_hex(blocks);
  return raw;
}

TargetBlock read_target_block(const RawBodyData& raw, int index) {
  std::ifstream file(raw.targets_path, std::ios::binary);
  TargetBlock block(kVertices);
  file.seekg(std::streamoff(std::size_t(index) * kBlockBytes));
  file.read(reinterpret_cast<char*>(block.data()), std::streamsize(kBlockBytes));
  if (!file)
    throw IoError(raw.targets_path + ": cannot read block " + std::to_string(index), kHint);
  return block;
}

void repair_target(const RawBodyData& raw, const std::string& name, TargetBlock& block) {
  if (!symmetric_groups().contains(group_of(name)) || one_sided_on_purpose(name)) return;
  const int good_side = right_half_is_good(name) ? -1 : 1;
  for (std::size_t v = 0; v < kVertices; ++v) {
    const auto x = raw.base[v][0] * good_side;
    if (x < 0) {
      const auto& good = block[std::size_t(raw.mirror[v])];
      block[v] = {std::int16_t(-good[0]), good[1], good[2]};
    } else if (x == 0) {
      block[v][0] = 0;
    }
  }
}

BodyData bake_body_data(const std::string& folder) {
  const RawBodyData raw = read_raw_body_data(folder);
  BodyData data;
  data.source_sha256 = raw.targets_sha256;
  data.body_vertices = kBodyVertices;
  // Vertices of the body and markers of its joints, in our frame and in metres.
  for (int v = 0; v < int(kVertices); ++v) {
    if (row_of(v) < 0) continue;
    const auto p = turned(raw.base[std::size_t(v)]);
    data.base.push_back(Vec3(p[0], p[1], p[2]) * 1e-5);
    data.mirror.push_back(row_of(raw.mirror[std::size_t(v)]));
  }
  data.quads.assign(raw.faces.begin(), raw.faces.begin() + kBodyFaces);

  // Skeleton and skin weights.
  const json mesh = read_json(folder + "/human_full_size.json");
  add_skeleton(folder, mesh, data);
  add_skin(mesh, data);

  using Key = std::pair<std::vector<std::uint16_t>, std::vector<std::array<std::int16_t, 3>>>;
  std::map<Key, int> known;  // many names share one field
  for (int t = 0; t < int(kTargets); ++t) {
    const std::string& name = raw.target_names[std::size_t(t)];
    if (!is_used(name)) continue;
    TargetBlock block = read_target_block(raw, t);
    repair_target(raw, name, block);
    BodyField field = field_of(block);
    int index = -1;
    if (!field.rows.empty()) {
      const auto [found, added] =
          known.emplace(Key(field.rows, field.shift), int(data.fields.size()));
      if (added) data.fields.push_back(std::move(field));
      index = found->second;
    }
    data.field_of_name.emplace(name, index);
  }
  return data;
}

}  // namespace loosefit::body
