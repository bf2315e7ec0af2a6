#pragma once
#include <string>
#include <utility>
#include <vector>

namespace loosefit::io {

/// What of a drawing became no piece: a line each, by its own name and with the reason.
class LeftOut {
 public:
  std::vector<std::string> unused;    ///< all of it, for the account of the file
  std::vector<std::string> warnings;  ///< what may have been cloth, a fold, a count or a hole

  /// What may have been cloth: in both lists.
  void tell(const std::string& line);
  /// Many things of one kind are one line of the account: their number and the names of the first.
  /// \param name as messages have it; empty: it has none
  void count(const std::string& kind, const std::string& name = {});
  /// The lines of what was counted, into the account.
  void sum_up();

 private:
  struct Kind {
    std::string kind;
    int number = 0;
    std::vector<std::string> names;
  };
  std::vector<Kind> counted_;
};

}  // namespace loosefit::io
