#pragma once
#include <memory>
#include <string>

#include "loosefit/base/error.h"

class vtkRenderWindow;

namespace loosefit::render {

/// There is nothing to draw on; the message says why, the hint what to do. Everything but pictures
/// can be done without.
class NoScreen : public Error {
 public:
  using Error::Error;
};

/// Where pictures are drawn: the X display that DISPLAY names, and where it names none or none that
/// can be drawn on, an X server of our own (render/x_server.h), which ends with the object. One
/// window for all scenes, since a second OpenGL context costs half a second. To be used and
/// destroyed in the thread that made it. The environment stays as it is.
class Screen {
 public:
  /// Every display is asked before VTK sees it, since VTK ends the whole process on one that does
  /// not answer or has no OpenGL. \throws NoScreen.
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// What it is, for people: "display :0", "own screen :1 (Xvfb)".
  std::string str() const;
  /// VTK's window on it.
  vtkRenderWindow* window() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace loosefit::render
