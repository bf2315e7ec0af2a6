#pragma once

namespace loosefit {

/// How many more drapes to make side by side, after the first: one per thread, as far as memory
/// goes. None takes more than the process has taken for the first one, which is the largest amount
/// so far when this is asked.
int drapes_at_once();

}  // namespace loosefit
