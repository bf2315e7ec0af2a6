#pragma once

namespace loosefit::solver {

/// While one of them lives, OpenBLAS works on one thread in the whole process (why: pin_blas.h);
/// after the last one it has as many as before. For programs that are not ours to start over, and
/// whose own arithmetic may want more threads.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
};

}  // namespace loosefit::solver
