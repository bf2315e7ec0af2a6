#pragma once
#include <stdexcept>
#include <string>

namespace loosefit {

/// Base of everything Loosefit throws on purpose. `hint` is shown to the user on a second line.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Where a bad value stands: printed as `FILE:LINE: KEY`. Empty parts are left out.
struct InputPlace {
  std::string file;
  int line = 0;
  std::string key;
  std::string str() const;
};

/// The user gave something we cannot use: exit code 2.
class InvalidInput : public Error {
 public:
  explicit InvalidInput(const std::string& complaint, std::string hint = {});
  /// Message `FILE:LINE: KEY: found FOUND, expected EXPECTED`.
  InvalidInput(const InputPlace& place, const std::string& found, const std::string& expected,
               std::string hint = {});

  const InputPlace& place() const { return place_; }
  /// What stands there and what should: the two halves of the complaint, for programs. Empty when
  /// it is told as one sentence.
  const std::string& found() const { return found_; }
  const std::string& expected() const { return expected_; }
  /// The same complaint with another place: of a caller who knows file and line of the value.
  InvalidInput at(const InputPlace& place) const;

 private:
  InputPlace place_;
  std::string complaint_;  ///< the message without its place
  std::string found_, expected_;
};

/// Geometry that cannot be processed (open mesh, seam that cannot close): exit code 2.
class GeometryError : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
  explicit GeometryError(const InvalidInput& error) : InvalidInput(error) {}
};

/// A file could not be read or written (missing, no permission, disk full): exit code 2.
class IoError : public Error {
 public:
  using Error::Error;
};

/// A numerical method gave up; the message says which and why: exit code 1.
class SolverFailure : public Error {
 public:
  using Error::Error;
};

/// The user pressed Ctrl-C: exit code 130, nothing half-written.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace loosefit
