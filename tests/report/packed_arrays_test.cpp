#include "loosefit/report/packed_arrays.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace loosefit::report {
namespace {

std::string from_base64(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (char c : text) {
    if (c == '=') break;
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                                             : 63;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

std::string unzipped(const std::string& bytes, std::size_t size) {
  std::string out(size, '\0');
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(stream.total_out, size);
  inflateEnd(&stream);
  return out;
}

/// Reads an array as the page does (web/src/case_data.ts).
std::vector<std::uint32_t> counts(const std::string& block, const std::string& description) {
  const auto json = nlohmann::json::parse(description);
  const std::size_t at = json["at"], count = json["count"], bytes = json["bytes"],
                    size = json["size"];
  std::vector<std::uint32_t> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t change = 0;
    for (std::size_t plane = bytes; plane-- > 0;)
      change = change << 8 | static_cast<std::uint8_t>(block[at + plane * count + i]);
    out[i] = change + (i < size ? 0 : out[i - size]);
    if (bytes < 4) out[i] &= (1u << 8 * bytes) - 1;
  }
  return out;
}

std::vector<double> numbers(const std::string& block, const std::string& description) {
  const auto json = nlohmann::json::parse(description);
  const std::size_t size = json["size"];
  std::vector<double> out;
  for (std::uint32_t stored : counts(block, description)) {
    const std::size_t k = out.size() % size;
    out.push_back(stored == kNotDefined
                      ? std::nan("")
                      : json["low"][k].get<double>() + json["step"][k].get<double>() * stored);
  }
  return out;
}

TEST(PackedArrays, CountsOfEveryWidthComeBack) {
  PackedArrays arrays;
  const std::vector<int> narrow = {0, 255, 3, 3, 254}, middle = {0, 65535, 1, 256, 255, 7},
                         wide = {0, 65536, 2'000'000'000, 5};
  const std::string a = arrays.add_counts(narrow), b = arrays.add_counts(middle, 3),
                    c = arrays.add_counts(wide, 2), none = arrays.add_counts({});
  const std::string block = unzipped(from_base64(arrays.gzip_base64()), arrays.bytes());
  EXPECT_EQ(arrays.bytes(), 5u + 12u + 16u);
  const auto same = [&](const std::string& description, const std::vector<int>& values) {
    const std::vector<std::uint32_t> read = counts(block, description);
    return std::equal(read.begin(), read.end(), values.begin(), values.end(),
                      [](std::uint32_t x, int y) { return x == static_cast<std::uint32_t>(y); });
  };
  EXPECT_TRUE(same(a, narrow) && same(b, middle) && same(c, wide) && same(none, {}));
}

TEST(PackedArrays, NumbersComeBackWithinHalfAStep) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> near(-0.03, 0.05);
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(near(random));
  values[7] = std::nan("");
  values[8] = std::numeric_limits<double>::infinity();
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(near(random), 100 * near(random), 5.0);
  PackedArrays arrays;
  const std::string v = arrays.add_values(values), p = arrays.add_points(points);
  const std::string block = unzipped(from_base64(arrays.gzip_base64()), arrays.bytes());
  const std::vector<double> read = numbers(block, v);
  ASSERT_EQ(read.size(), values.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    if (i == 7 || i == 8)
      EXPECT_TRUE(std::isnan(read[i]));
    else
      EXPECT_NEAR(read[i], values[i], 0.5000001 * 0.08 / 65534);
  const std::vector<double> place = numbers(block, p);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(place[3 * i + 1], points[i].y(), 0.5000001 * 8 / 65534);
    EXPECT_EQ(place[3 * i + 2], 5.0);
  }
}

TEST(PackedArrays, EqualInputGivesEqualBytesAndNeighboursShrink) {
  std::vector<double> smooth;
  for (int i = 0; i < 5000; ++i) smooth.push_back(std::sin(i / 300.0));
  PackedArrays a, b;
  a.add_values(smooth);
  b.add_values(smooth);
  EXPECT_EQ(a.gzip_base64(), b.gzip_base64());
  EXPECT_LT(a.gzip_base64().size(), a.bytes() / 2);
}

TEST(PackedArrays, NothingDefinedIsNotANumberEverywhere) {
  PackedArrays arrays;
  const std::string v = arrays.add_values({std::nan(""), std::nan("")});
  const std::string block = unzipped(from_base64(arrays.gzip_base64()), arrays.bytes());
  for (double value : numbers(block, v)) EXPECT_TRUE(std::isnan(value));
}

}  // namespace
}  // namespace loosefit::report
