#include "loosefit/contact/sticky_pattern.h"

#include <algorithm>

#include "loosefit/contact/contact_tuning.h"

namespace loosefit::contact {

void StickyPattern::use_block(int i, int j) {
  const int row = std::max(i, j);
  auto& rows = rows_of_column_[std::min(i, j)];
  for (Entry& e : rows) {
    if (e.row != row) continue;
    used_ += e.last_use != now_;
    e.last_use = now_;
    return;
  }
  rows.push_back({row, now_});
  ++size_;
  ++used_;
  grown_ = true;
}

void StickyPattern::end(bool complete) {
  const bool trim = complete && size_ > 2 * used_ + kContact.barrier.pattern_slack;
  if (trim) {
    for (auto& rows : rows_of_column_)
      rows.erase(std::remove_if(rows.begin(), rows.end(),
                                [&](const Entry& e) { return e.last_use != now_; }),
                 rows.end());
    size_ = used_;
  }
  if (trim || grown_) ++version_;
  grown_ = false;
}

void StickyPattern::recall(const StickyPattern& earlier) {
  const std::uint64_t next = std::max(version_, earlier.version_) + 1;
  *this = earlier;
  version_ = next;
}

void StickyPattern::add_to(particles::BlockPattern& pattern) const {
  for (std::size_t column = 0; column < rows_of_column_.size(); ++column)
    for (const Entry& e : rows_of_column_[column]) pattern.add(e.row, static_cast<int>(column));
}

}  // namespace loosefit::contact
