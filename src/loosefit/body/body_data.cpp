#include "loosefit/body/body_data.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"

namespace loosefit::body {
namespace {

static_assert(std::endian::native == std::endian::little, "the baked file is little-endian");

constexpr char kMagic[8] = {'L', 'F', 'B', 'O', 'D', 'Y', '0', '1'};
constexpr double kBaseUnit = 1e-5;  // base mesh: four decimals of a decimetre
constexpr std::uint64_t kLargestPayload = 1u << 28;

class Writer {
 public:
  template <class T>
  void put(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void text(const std::string& s) {
    put(std::uint16_t(s.size()));
    bytes_ += s;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string bytes, const std::string& path) : bytes_(std::move(bytes)), path_(path) {}
  template <class T>
  T get() {
    need(sizeof(T));
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  /// A count of things that take at least `bytes_each` bytes, so that damage cannot ask for memory.
  std::size_t count(std::size_t bytes_each) {
    const auto n = get<std::uint32_t>();
    need(n * bytes_each);
    return n;
  }
  int index(std::size_t limit) {
    const auto i = get<std::uint16_t>();
    if (i >= limit) damaged();
    return i;
  }
  std::string text() {
    const auto n = get<std::uint16_t>();
    need(n);
    std::string s = bytes_.substr(at_, n);
    at_ += n;
    return s;
  }
  [[noreturn]] void damaged() const {
    throw IoError(path_ + ": found a damaged body file", "delete it and run: loosefit setup");
  }

 private:
  void need(std::size_t n) const {
    if (n > bytes_.size() - at_) damaged();
  }
  std::string bytes_;
  std::string path_;
  std::size_t at_ = 0;
};

// Differences along the vertex order compress far better than the values themselves.
void put_field(Writer& out, const BodyField& field) {
  out.put(std::uint32_t(field.rows.size()));
  std::uint16_t last_row = 0;
  for (const auto row : field.rows) {
    out.put(std::uint16_t(row - last_row));
    last_row = row;
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::int16_t last = 0;
    for (const auto& shift : field.shift) {
      out.put(std::int16_t(shift[axis] - last));
      last = shift[axis];
    }
  }
}

BodyField get_field(Reader& in, std::size_t row_count) {
  BodyField field;
  field.rows.resize(in.count(8));
  field.shift.resize(field.rows.size());
  std::uint16_t row = 0;
  for (auto& r : field.rows) {
    row = std::uint16_t(row + in.get<std::uint16_t>());
    if (row >= row_count) in.damaged();
    r = row;
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::int16_t value = 0;
    for (auto& shift : field.shift)
      shift[axis] = value = std::int16_t(value + in.get<std::int16_t>());
  }
  return field;
}

std::string payload_of(const BodyData& data) {
  // Fields and their order are the file format: data_of reads the same. First the base mesh.
  Writer out;
  out.text(data.source_sha256);
  out.put(std::uint32_t(data.base.size()));
  out.put(std::uint16_t(data.body_vertices));
  for (const auto& p : data.base) {
    for (int axis = 0; axis < 3; ++axis) out.put(std::int32_t(std::lround(p[axis] / kBaseUnit)));
  }
  // Mirror partners, as many as there are base vertices, so without a count.
  for (const int row : data.mirror) out.put(std::uint16_t(row));
  // Faces.
  out.put(std::uint32_t(data.quads.size()));
  for (const auto& quad : data.quads) {
    for (const int corner : quad) out.put(std::uint16_t(corner));
  }
  // Joints, each by the vertices that surround it, and the bones between them.
  out.put(std::uint32_t(data.joints.size()));
  for (const auto& rows : data.joints) {
    out.put(std::uint32_t(rows.size()));
    for (const int row : rows) out.put(std::uint16_t(row));
  }
  out.put(std::uint32_t(data.bones.size()));
  for (const auto& bone : data.bones) {
    out.text(bone.name);
    out.put(std::int16_t(bone.parent));
    out.put(std::uint16_t(bone.head));
    out.put(std::uint16_t(bone.tail));
  }
  // Skinning weights, one list per vertex of the body.
  for (const auto& influences : data.skin) {
    out.put(std::uint32_t(influences.size()));
    for (const auto& [bone, weight] : influences) {
      out.put(std::uint16_t(bone));
      out.put(weight);
    }
  }
  // Shape fields, and the names by which they are found.
  out.put(std::uint32_t(data.fields.size()));
  for (const auto& field : data.fields) put_field(out, field);
  out.put(std::uint32_t(data.field_of_name.size()));
  for (const auto& [name, field] : data.field_of_name) {
    out.text(name);
    out.put(std::int16_t(field));
  }
  return out.bytes();
}

BodyData data_of(Reader in) {
  // Read in the order of payload_of; counts and indices are checked before use. First the mesh.
  BodyData data;
  data.source_sha256 = in.text();
  data.base.resize(in.count(12));
  data.body_vertices = in.get<std::uint16_t>();
  const std::size_t rows = data.base.size();
  if (data.body_vertices <= 0 || std::size_t(data.body_vertices) > rows) in.damaged();
  for (auto& p : data.base) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = in.get<std::int32_t>() * kBaseUnit;
  }
  // Mirror partners, one per base vertex.
  data.mirror.resize(rows);
  for (auto& row : data.mirror) row = in.index(rows);
  // Faces, of vertices of the body only.
  data.quads.resize(in.count(8));
  for (auto& quad : data.quads) {
    for (auto& corner : quad) corner = in.index(std::size_t(data.body_vertices));
  }
  // Joints are means of vertices, so none may be empty.
  data.joints.resize(in.count(4));
  for (auto& joint : data.joints) {
    joint.resize(in.count(2));
    if (joint.empty()) in.damaged();
    for (auto& row : joint) row = in.index(rows);
  }
  // A parent comes before its children, so that one pass poses all.
  data.bones.resize(in.count(8));
  for (std::size_t b = 0; b < data.bones.size(); ++b) {
    auto& bone = data.bones[b];
    bone.name = in.text();
    bone.parent = in.get<std::int16_t>();
    if (bone.parent >= int(b)) in.damaged();
    bone.head = in.index(data.joints.size());
    bone.tail = in.index(data.joints.size());
  }
  // Skinning weights, one list per vertex of the body.
  data.skin.resize(std::size_t(data.body_vertices));
  for (auto& influences : data.skin) {
    influences.resize(in.count(10));
    for (auto& [bone, weight] : influences) {
      bone = in.index(data.bones.size());
      weight = in.get<double>();
    }
  }
  // Shape fields, and their names; a name with -1 stands for one that is all zero.
  const std::size_t fields = in.count(4);
  for (std::size_t f = 0; f < fields; ++f) data.fields.push_back(get_field(in, rows));
  for (std::size_t n = in.count(4); n > 0; --n) {
    std::string name = in.text();
    const int field = in.get<std::int16_t>();
    if (field < -1 || field >= int(fields)) in.damaged();
    data.field_of_name.emplace(std::move(name), field);
  }
  return data;
}

}  // namespace

int BodyData::bone(const std::string& name) const {
  for (std::size_t b = 0; b < bones.size(); ++b) {
    if (bones[b].name == name) return int(b);
  }
  throw InvalidInput("the body data have no bone named " + name);
}

void write_body_data(const std::string& path, const BodyData& data) {
  const std::string payload = payload_of(data);
  uLongf packed_size = compressBound(payload.size());
  std::string packed(packed_size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &packed_size,
                reinterpret_cast<const Bytef*>(payload.data()), payload.size(), 9) != Z_OK) {
    throw IoError(path + ": zlib could not compress the body data");
  }
  // A reader never sees half a file: write beside it, then rename.
  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  const std::uint64_t size = payload.size();
  file.write(kMagic, sizeof kMagic);
  file.write(reinterpret_cast<const char*>(&size), sizeof size);
  file.write(packed.data(), std::streamsize(packed_size));
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(part, path, error);
  if (!file || error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw IoError(path + ": cannot write the baked body",
                  "is the folder there, writable, and not full?");
  }
}

BodyData read_body_data(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw IoError(path + ": found no body data",
                  "run: loosefit setup (fetches and bakes it once), or set LOOSEFIT_DATA; " +
                      looked_in());
  }
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  constexpr std::size_t kHeader = sizeof kMagic + sizeof(std::uint64_t);
  if (bytes.size() < kHeader || std::memcmp(bytes.data(), kMagic, 6) != 0) {
    throw IoError(path + ": found another kind of file, expected baked body data",
                  "delete it and run: loosefit setup");
  }
  if (std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0) {
    throw IoError(fmt::format("{}: found body data version {}, expected {}", path,
                              bytes.substr(6, 2), std::string(kMagic + 6, 2)),
                  "run: loosefit setup");
  }
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data() + sizeof kMagic, sizeof size);
  std::string payload(size <= kLargestPayload ? size : 0, '\0');
  uLongf unpacked = payload.size();
  if (payload.empty() ||
      uncompress(reinterpret_cast<Bytef*>(payload.data()), &unpacked,
                 reinterpret_cast<const Bytef*>(bytes.data() + kHeader),
                 bytes.size() - kHeader) != Z_OK ||
      unpacked != size) {
    throw IoError(path + ": found a damaged body file", "delete it and run: loosefit setup");
  }
  return data_of(Reader(std::move(payload), path));
}

}  // namespace loosefit::body
