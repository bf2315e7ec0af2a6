#pragma once

namespace loosefit::render {

/// VTK aborts the process without an X display, so this is asked before anything is drawn.
/// \throws Error "pictures need a display" with the way out as hint.
void check_display();

}  // namespace loosefit::render
