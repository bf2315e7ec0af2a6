#include "loosefit/render/screen.h"

#include <vtkAutoInit.h>
#include <vtkRenderWindow.h>
#include <vtkXOpenGLRenderWindow.h>
// After VTK: these headers define macros such as None and Bool.
#include <GL/glx.h>
#include <X11/Xlib.h>

#include <cstdlib>
#include <mutex>
#include <optional>

#include "loosefit/render/x_server.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkInteractionStyle)

namespace loosefit::render {
namespace {

constexpr const char* kHint =
    "install the package xvfb, or set DISPLAY to an X server that runs; loosefit render DIR then "
    "draws what is missing";

/// Xlib keeps keys and error handlers for the whole process.
std::mutex& xlib_globals() {
  static std::mutex mutex;
  return mutex;
}

bool refused = false;  // guarded by xlib_globals
int note_refusal(Display*, XErrorEvent*) {
  refused = true;
  return 0;
}

/// Whether the display has what VTK draws with: GLX and an OpenGL context of version 3.2.
bool has_opengl(Display* display) {
  int error_base = 0, event_base = 0;
  if (!glXQueryExtension(display, &error_base, &event_base)) return false;
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_WINDOW_BIT,
                        GLX_RENDER_TYPE,
                        GLX_RGBA_BIT,
                        GLX_RED_SIZE,
                        1,
                        GLX_GREEN_SIZE,
                        1,
                        GLX_BLUE_SIZE,
                        1,
                        GLX_DEPTH_SIZE,
                        1,
                        None};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
      glXGetProcAddress(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
  bool made = false;
  if (configs && count > 0 && create) {
    const int version[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2,
                           None};
    const std::lock_guard lock(xlib_globals());
    refused = false;
    const auto before = XSetErrorHandler(note_refusal);
    const GLXContext context = create(display, configs[0], nullptr, True, version);
    XSync(display, False);
    XSetErrorHandler(before);
    made = context && !refused;
    if (context) glXDestroyContext(display, context);
  }
  if (configs) XFree(configs);
  return made;
}

Display* open_own(const XServer& server) {
  const std::lock_guard lock(xlib_globals());
  std::string protocol = "MIT-MAGIC-COOKIE-1", key = server.cookie();
  XSetAuthorization(protocol.data(), static_cast<int>(protocol.size()), key.data(),
                    static_cast<int>(key.size()));
  Display* display = XOpenDisplay(server.name().c_str());
  XSetAuthorization(nullptr, 0, nullptr, 0);
  return display;
}

}  // namespace

struct Screen::Parts {
  std::optional<XServer> server;
  Display* display = nullptr;
  vtkRenderWindow* window = nullptr;

  ~Parts() {
    if (window) window->Delete();
    leave();
  }
  void leave() {
    if (display) XCloseDisplay(display);
    display = nullptr;
    server.reset();
  }
  /// Takes the display that the environment names; else says why not.
  std::string take_given() {
    const char* named = std::getenv("DISPLAY");
    if (!named || !*named) return "DISPLAY is not set";
    const std::string name = std::string("DISPLAY '") + named + "'";
    display = XOpenDisplay(nullptr);
    if (!display) return "no X server answers at " + name;
    if (has_opengl(display)) return {};
    leave();
    return name + " has no OpenGL 3.2";
  }
  /// Takes a server of our own; else says why not.
  std::string take_own() {
    try {
      server.emplace();
    } catch (const Error& error) {
      return error.what();
    }
    display = open_own(*server);
    const bool good = display && has_opengl(display);
    if (good) return {};
    const bool answers = display != nullptr;
    leave();
    return answers ? "Xvfb has no OpenGL 3.2 here" : "Xvfb does not answer";
  }
};

Screen::Screen() : parts_(std::make_unique<Parts>()) {
  if (const std::string given = parts_->take_given(); !given.empty())
    if (const std::string own = parts_->take_own(); !own.empty())
      throw NoScreen("pictures need a screen: " + given + ", and " + own, kHint);
  parts_->window = vtkRenderWindow::New();
  auto* x_window = vtkXOpenGLRenderWindow::SafeDownCast(parts_->window);
  if (!x_window)
    throw NoScreen("pictures need VTK's OpenGL window, found " +
                   std::string(parts_->window->GetClassName()));
  x_window->SetDisplayId(parts_->display);
  // Pictures are read from where they are drawn: nobody looks at the window itself.
  x_window->SetFrameBlitModeToNoBlit();
  x_window->SetSwapBuffers(0);
}

Screen::~Screen() = default;

std::string Screen::str() const {
  if (parts_->server) return "own screen " + parts_->server->name() + " (Xvfb)";
  return std::string("display ") + DisplayString(parts_->display);
}

vtkRenderWindow* Screen::window() const { return parts_->window; }

}  // namespace loosefit::render
