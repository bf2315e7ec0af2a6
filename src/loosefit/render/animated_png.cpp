#include "loosefit/render/animated_png.h"

#include <zlib.h>

#include <cstdint>
#include <string_view>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"

namespace loosefit::render {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

[[noreturn]] void refuse(const char* found) {
  throw InvalidInput(std::string("animation: found ") + found +
                     ", expected PNG files of one size and one kind of pixel");
}

void put32(std::string& bytes, std::uint32_t value) {
  for (int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}
void put16(std::string& bytes, std::uint32_t value) {
  for (int shift : {8, 0}) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}
std::uint32_t get32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

void put_chunk(std::string& file, const std::string& type, const std::string& data) {
  put32(file, static_cast<std::uint32_t>(data.size()));
  const std::string body = type + data;
  file += body;
  put32(file, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                               static_cast<uInt>(body.size()))));
}

/// What an animation needs of a PNG file.
struct Frame {
  std::string header;  ///< data of IHDR
  std::string pixels;  ///< of all IDAT chunks, one after another
};

Frame frame_of(std::string_view file) {
  if (!file.starts_with(kSignature)) refuse("something that is not a PNG file");
  Frame frame;
  file.remove_prefix(kSignature.size());
  while (file.size() >= 12) {
    const std::size_t length = get32(file);
    if (file.size() - 12 < length) refuse("a PNG file that is cut short");
    const std::string_view type = file.substr(4, 4), data = file.substr(8, length);
    if (type == "IHDR") frame.header = data;
    if (type == "IDAT") frame.pixels += data;
    file.remove_prefix(12 + length);
  }
  if (frame.header.size() != 13 || frame.pixels.empty()) refuse("a PNG file without a picture");
  return frame;
}

}  // namespace

std::string animated_png(const std::vector<std::string>& frames, int milliseconds) {
  LOOSEFIT_ASSERT(!frames.empty());
  std::string file(kSignature);
  std::uint32_t sequence = 0;
  std::string header;
  for (const std::string& bytes : frames) {
    const Frame frame = frame_of(bytes);
    const bool first = header.empty();
    if (first) {
      header = frame.header;
      put_chunk(file, "IHDR", header);
      std::string control;  // number of frames; 0: play for ever
      put32(control, static_cast<std::uint32_t>(frames.size()));
      put32(control, 0);
      put_chunk(file, "acTL", control);
    } else if (frame.header != header) {
      refuse("one that differs");
    }
    std::string control;
    put32(control, sequence++);
    control += header.substr(0, 8);  // width, height
    put32(control, 0);               // at the left
    put32(control, 0);               // at the top
    put16(control, static_cast<std::uint32_t>(milliseconds));
    put16(control, 1000);
    control += std::string(2, '\0');  // leave it; replace what was there
    put_chunk(file, "fcTL", control);
    if (first) {
      put_chunk(file, "IDAT", frame.pixels);
    } else {
      std::string data;
      put32(data, sequence++);
      put_chunk(file, "fdAT", data + frame.pixels);
    }
  }
  put_chunk(file, "IEND", "");
  return file;
}

}  // namespace loosefit::render
