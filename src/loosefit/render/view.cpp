#include "loosefit/render/view.h"

#include "loosefit/base/error.h"

namespace loosefit::render {

const char* name(View view) {
  switch (view) {
    case View::front:
      return "front";
    case View::back:
      return "back";
    case View::left:
      return "left";
    case View::right:
      return "right";
  }
  return "front";
}

View view_from_name(const std::string& text) {
  for (View view : {View::front, View::back, View::left, View::right})
    if (text == name(view)) return view;
  throw InvalidInput("unknown view '" + text + "', expected front, back, left or right");
}

}  // namespace loosefit::render
