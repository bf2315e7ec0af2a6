#pragma once

namespace loosefit::solver::dense {

/// A thread's place at OpenBLAS while it lives: the work memory of one call is there. OpenBLAS asks
/// for that memory inside the call, by itself, and asks again for ever when there is none. So no
/// more calls are under way at once than there is memory for; a thread without a place waits.
/// Hold it round single calls only, never while other tasks are waited for.
class KernelSeat {
 public:
  /// \throws std::bad_alloc where there is no memory for even one call.
  KernelSeat();
  ~KernelSeat();
  KernelSeat(const KernelSeat&) = delete;
  KernelSeat& operator=(const KernelSeat&) = delete;
};

}  // namespace loosefit::solver::dense
