#include "loosefit/render/display.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <cstring>

#include "loosefit/base/error.h"

namespace loosefit::render {
namespace {
constexpr const char* kHint =
    "start it with: xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\" loosefit …   (package "
    "xvfb); loosefit run --no-pictures does without pictures, loosefit map makes maps and sites "
    "anew";

/// An X server listens on a file socket or on its abstract twin.
bool listens(const std::string& number, bool abstract) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = "/tmp/.X11-unix/X" + number;
  const std::size_t skip = abstract ? 1 : 0;
  if (name.size() + skip >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path + skip, name.data(), name.size());
  const int handle = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (handle < 0) return false;
  const auto length =
      static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + skip + name.size() + (skip ? 0 : 1));
  const bool ok = connect(handle, reinterpret_cast<const sockaddr*>(&address), length) == 0;
  close(handle);
  return ok;
}
}  // namespace

void check_display() {
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
    throw Error("pictures need a display: the environment variable DISPLAY is not set", kHint);
  const std::string text = display;
  const std::size_t colon = text.rfind(':');
  const bool here = colon == 0 || text.compare(0, colon, "unix") == 0;
  std::string number;
  if (colon != std::string::npos)
    for (std::size_t i = colon + 1; i < text.size() && std::isdigit(text[i]); ++i)
      number += text[i];
  if (number.empty())
    throw Error("pictures need a display: DISPLAY is '" + text + "', expected something like ':0'",
                kHint);
  // A display of another machine is left to X itself.
  if (here && !listens(number, false) && !listens(number, true))
    throw Error("pictures need a display: no X server answers at DISPLAY '" + text + "'", kHint);
}

}  // namespace loosefit::render
