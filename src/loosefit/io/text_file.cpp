#include "loosefit/io/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "loosefit/base/error.h"
#include "loosefit/io/text_encoding.h"

namespace loosefit::io {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string cause() { return std::strerror(errno); }

}  // namespace

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw IoError(path + ": found no such file");
  if (!std::filesystem::is_regular_file(status))
    throw IoError(path + ": found something that is not a file, expected a readable file");
  const File file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw IoError(path + ": cannot be read: " + cause());
  std::string text;
  char block[1 << 16];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file.get())) {
    text.append(block, n);
    if (text.size() > max_bytes)
      throw InvalidInput({path, 0, ""}, "more than " + std::to_string(max_bytes) + " bytes",
                         "a file of at most " + std::to_string(max_bytes) + " bytes");
  }
  if (std::ferror(file.get())) throw IoError(path + ": cannot be read: " + cause());
  return text;
}

std::string read_plain_text(const std::string& path, std::size_t max_bytes) {
  return plain_text(read_text_file(path, max_bytes));
}

void write_text_file(const std::string& path, const std::string& text) {
  File file(std::fopen(path.c_str(), "wb"), &std::fclose);
  if (!file) throw IoError(path + ": cannot be written: " + cause());
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  // fclose can be the first to learn of a full disk.
  if (!written || std::fclose(file.release()) != 0)
    throw IoError(path + ": cannot be written: " + cause());
}

}  // namespace loosefit::io
