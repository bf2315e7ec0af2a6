#include "loosefit/io/glb_write.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"
#include "loosefit/base/version.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125, kUnsignedShort = 5123;
constexpr int kVertexData = 34962, kIndexData = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

double to_linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::array<float, 3> y_up(const Vec3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.z()), static_cast<float>(-p.y())};
}

/// The parts of a file under construction.
struct File {
  Json json;
  std::string binary;

  template <class Number>
  int add(const std::vector<Number>& numbers, int component, const char* type, int size, int target,
          bool normalized = false) {
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t bytes = numbers.size() * sizeof(Number);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes}, {"target", target}});
    binary.append(reinterpret_cast<const char*>(numbers.data()), bytes);
    Json accessor = {{"bufferView", json["bufferViews"].size() - 1},
                     {"componentType", component},
                     {"count", numbers.size() / static_cast<std::size_t>(size)},
                     {"type", type}};
    if (normalized) accessor["normalized"] = true;
    json["accessors"].push_back(accessor);
    return static_cast<int>(json["accessors"].size()) - 1;
  }
};

void check(const GlbSurface& surface) {
  const auto n = surface.positions.size();
  if (surface.triangles.empty())
    throw InvalidInput("GLB: surface '" + surface.name + "' has no triangles");
  if (!surface.colours.empty() && surface.colours.size() != n)
    throw InvalidInput("GLB: surface '" + surface.name + "' has " +
                       std::to_string(surface.colours.size()) + " colours, expected " +
                       std::to_string(n) + ", one per vertex");
  for (const Triangle& t : surface.triangles)
    for (int v : t)
      if (v < 0 || static_cast<std::size_t>(v) >= n)
        throw InvalidInput("GLB: a triangle of surface '" + surface.name + "' has corner " +
                           std::to_string(v) + ", expected one of 0 to " + std::to_string(n - 1));
}

int add_positions(File& file, const std::vector<Vec3>& positions) {
  std::vector<float> numbers;
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  for (const Vec3& p : positions) {
    const std::array<float, 3> at = y_up(p);
    numbers.insert(numbers.end(), at.begin(), at.end());
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  const int accessor = file.add(numbers, kFloat, "VEC3", 3, kVertexData);
  file.json["accessors"][accessor]["min"] = low;
  file.json["accessors"][accessor]["max"] = high;
  return accessor;
}

int add_normals(File& file, const GlbSurface& surface) {
  std::vector<float> numbers;
  for (Vec3 n : geometry::vertex_normals(surface.positions, surface.triangles)) {
    if (!(n.norm() > 0.5)) n = Vec3::UnitZ();  // of a vertex without area
    const std::array<float, 3> at = y_up(n);
    numbers.insert(numbers.end(), at.begin(), at.end());
  }
  return file.add(numbers, kFloat, "VEC3", 3, kVertexData);
}

/// Four components: three of 16 bits would not keep to the alignment that the format asks for.
int add_colours(File& file, const std::vector<std::array<std::uint8_t, 3>>& colours) {
  std::vector<std::uint16_t> numbers;
  for (const auto& colour : colours) {
    for (std::uint8_t channel : colour)
      numbers.push_back(static_cast<std::uint16_t>(std::lround(65535 * to_linear(channel))));
    numbers.push_back(65535);
  }
  return file.add(numbers, kUnsignedShort, "VEC4", 4, kVertexData, true);
}

int add_triangles(File& file, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> numbers;
  for (const Triangle& t : triangles) numbers.insert(numbers.end(), t.begin(), t.end());
  return file.add(numbers, kUnsignedInt, "SCALAR", 1, kIndexData);
}

void add_surface(File& file, const GlbSurface& surface) {
  Json attributes = {{"POSITION", add_positions(file, surface.positions)},
                     {"NORMAL", add_normals(file, surface)}};
  Json base = {1, 1, 1, 1};
  if (surface.colours.empty())
    for (int k = 0; k < 3; ++k) base[k] = to_linear(surface.colour[k]);
  else
    attributes["COLOR_0"] = add_colours(file, surface.colours);
  const std::size_t index = file.json["meshes"].size();
  file.json["materials"].push_back(
      {{"name", surface.name},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", base}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
       {"doubleSided", surface.two_sided}});
  file.json["meshes"].push_back({{"name", surface.name},
                                 {"primitives",
                                  {{{"attributes", attributes},
                                    {"indices", add_triangles(file, surface.triangles)},
                                    {"material", index}}}}});
  file.json["nodes"].push_back({{"name", surface.name}, {"mesh", index}});
  file.json["scenes"][0]["nodes"].push_back(index);
}

void append(std::string& bytes, std::uint32_t number) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(number >> 8 * k & 255);
}

void append_chunk(std::string& bytes, std::uint32_t kind, std::string chunk, char padding) {
  chunk.resize((chunk.size() + 3) / 4 * 4, padding);
  append(bytes, static_cast<std::uint32_t>(chunk.size()));
  append(bytes, kind);
  bytes += chunk;
}

}  // namespace

void write_glb(const std::filesystem::path& path, const std::vector<GlbSurface>& surfaces,
               const std::vector<std::array<std::string, 2>>& notes) {
  File file;
  file.json["asset"] = {{"version", "2.0"}, {"generator", "Loosefit " + version()}};
  for (const auto& [name, text] : notes) file.json["asset"]["extras"][name] = text;
  file.json["scene"] = 0;
  file.json["scenes"] = Json::array({{{"nodes", Json::array()}}});
  for (const GlbSurface& surface : surfaces) {
    check(surface);
    add_surface(file, surface);
  }
  file.json["buffers"] = Json::array({{{"byteLength", (file.binary.size() + 3) / 4 * 4}}});

  std::string chunks;
  append_chunk(
      chunks, kJsonChunk,
      json_without_controls(file.json.dump(-1, ' ', false, Json::error_handler_t::replace)), ' ');
  append_chunk(chunks, kBinaryChunk, file.binary, '\0');
  std::string bytes;
  append(bytes, kMagic);
  append(bytes, 2);
  append(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  bytes += chunks;
  write_text_file(path.string(), bytes);
}

}  // namespace loosefit::io
