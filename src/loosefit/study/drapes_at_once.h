#pragma once

namespace loosefit {

/// How many more drapes to make side by side: one per thread, as far as memory goes. To be asked
/// right after the first one, for none takes more than the process has taken until then.
int drapes_at_once();

}  // namespace loosefit
