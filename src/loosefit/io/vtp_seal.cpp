#include "loosefit/io/vtp_seal.h"

#include "loosefit/base/sha256.h"

namespace loosefit::io {

std::string vtp_seal(const std::string& bytes_before) {
  return "<!-- sha256 " + sha256_hex(bytes_before) + " -->\n";
}

bool vtp_seal_matches(const std::string& file) {
  const std::size_t length = vtp_seal({}).size();
  if (file.size() < length) return false;
  const std::size_t body = file.size() - length;
  return file.compare(body, length, vtp_seal(file.substr(0, body))) == 0;
}

}  // namespace loosefit::io
