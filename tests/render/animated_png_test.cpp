#include "loosefit/render/animated_png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/render/figure.h"
#include "support/png_pixels.h"
#include "support/scratch_folder.h"

namespace loosefit::render {
namespace {

std::string frame(Rgb colour, int width = 60) {
  return figure_file({{{Image(width, 50, colour), ""}}, {}, 1, ""}, FigureFormat::png);
}

std::uint32_t number(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

struct Chunk {
  std::string type, data;
};

/// All chunks, each of which must carry its own checksum.
std::vector<Chunk> chunks(const std::string& file) {
  std::vector<Chunk> found;
  std::size_t at = 8;
  while (at + 12 <= file.size()) {
    const std::size_t length = number(file, at);
    found.push_back({file.substr(at + 4, 4), file.substr(at + 8, length)});
    const std::string body = found.back().type + found.back().data;
    EXPECT_EQ(number(file, at + 8 + length),
              crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())))
        << found.back().type;
    at += 12 + length;
  }
  EXPECT_EQ(at, file.size());
  return found;
}

TEST(AnimatedPng, HasAllFramesInOneSequence) {
  const std::string file =
      animated_png({frame({255, 0, 0}), frame({0, 255, 0}), frame({0, 0, 255})}, 40);
  std::vector<std::string> types;
  std::vector<std::uint32_t> sequence;
  for (const Chunk& chunk : chunks(file)) {
    types.push_back(chunk.type);
    if (chunk.type == "acTL") {
      EXPECT_EQ(number(chunk.data, 0), 3u);
    }
    if (chunk.type == "fcTL" || chunk.type == "fdAT") sequence.push_back(number(chunk.data, 0));
    if (chunk.type == "fcTL") {
      ASSERT_EQ(chunk.data.size(), 26u);
      EXPECT_EQ(number(chunk.data, 20), 40u << 16 | 1000u) << "40 of 1000 parts of a second";
    }
  }
  EXPECT_EQ(types, (std::vector<std::string>{"IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL",
                                             "fdAT", "IEND"}));
  EXPECT_EQ(sequence, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(AnimatedPng, ShowsItsFirstFrameToReadersThatDoNotKnowIt) {
  const support::ScratchFolder scratch;
  const auto path = scratch / "animated.png";
  std::ofstream(path, std::ios::binary) << animated_png({frame({9, 8, 7}), frame({0, 255, 0})}, 40);
  const Image image = testing::png_pixels(path);
  EXPECT_EQ(image.at(image.width / 2, image.height / 2), (Rgb{9, 8, 7}));
}

TEST(AnimatedPng, RefusesFramesThatDoNotFitTogether) {
  EXPECT_THROW(animated_png({frame({1, 1, 1}), frame({1, 1, 1}, 61)}, 40), InvalidInput);
  EXPECT_THROW(animated_png({"GIF89a"}, 40), InvalidInput);
  std::string cut = frame({1, 1, 1});
  cut.resize(cut.size() / 2);
  EXPECT_THROW(animated_png({cut}, 40), InvalidInput);
}

}  // namespace
}  // namespace loosefit::render
