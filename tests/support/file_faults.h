#pragma once
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "support/fault_plan.h"

// Makes the n-th change to the file system fail, or kills the process just before it: these
// definitions come before those of the C library. To be included in one file of a program.
namespace loosefit::faults {

inline int done(long result) { return static_cast<int>(result); }

}  // namespace loosefit::faults

extern "C" {

int renameat2(int from_at, const char* from, int to_at, const char* to, unsigned flags) noexcept {
  if (loosefit::faults::strikes("renameat2", to)) return -1;
  return loosefit::faults::done(syscall(SYS_renameat2, from_at, from, to_at, to, flags));
}

int rename(const char* from, const char* to) noexcept {
  if (loosefit::faults::strikes("rename", to)) return -1;
  return loosefit::faults::done(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (loosefit::faults::strikes("mkdir", path)) return -1;
  return loosefit::faults::done(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

int rmdir(const char* path) noexcept {
  if (loosefit::faults::strikes("rmdir", path)) return -1;
  return loosefit::faults::done(syscall(SYS_unlinkat, AT_FDCWD, path, AT_REMOVEDIR));
}

int unlink(const char* path) noexcept {
  if (loosefit::faults::strikes("unlink", path)) return -1;
  return loosefit::faults::done(syscall(SYS_unlinkat, AT_FDCWD, path, 0));
}

int unlinkat(int at, const char* path, int flags) noexcept {
  if (loosefit::faults::strikes("unlinkat", path)) return -1;
  return loosefit::faults::done(syscall(SYS_unlinkat, at, path, flags));
}

int remove(const char* path) noexcept {
  if (loosefit::faults::strikes("remove", path)) return -1;
  struct stat found;
  const bool folder = lstat(path, &found) == 0 && S_ISDIR(found.st_mode);
  return loosefit::faults::done(syscall(SYS_unlinkat, AT_FDCWD, path, folder ? AT_REMOVEDIR : 0));
}

/// Thousands of tests need not wait for the disk.
int fsync(int descriptor) {
  char path[4096] = "";
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  if (readlink(link.c_str(), path, sizeof path - 1) < 0) path[0] = 0;
  return loosefit::faults::strikes("fsync", path) ? -1 : 0;
}

std::FILE* fopen(const char* path, const char* mode) {
  if (mode[0] != 'r' && loosefit::faults::strikes("fopen", path)) return nullptr;
  using Open = std::FILE* (*)(const char*, const char*);
  static const Open real = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "fopen"));
  return real(path, mode);
}

}  // extern "C"
