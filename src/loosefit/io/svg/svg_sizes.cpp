#include "loosefit/io/svg/svg_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "loosefit/io/svg/svg_labels.h"

namespace loosefit::io {
bool stands_in(const SvgShape& shape, int group) {
  return group >= 0 &&
         std::find(shape.groups.begin(), shape.groups.end(), group) != shape.groups.end();
}

const SvgLine* seam_of_size(const SvgDocument& document, const SvgLine& cut,
                            const std::vector<const SvgLine*>& others,
                            std::vector<const SvgLine*> seams, const std::string& size,
                            std::vector<std::string>& notes) {
  std::stable_sort(seams.begin(), seams.end(),
                   [](const SvgLine* a, const SvgLine* b) { return a->area > b->area; });
  std::vector<const SvgLine*> within;
  std::copy_if(seams.begin(), seams.end(), std::back_inserter(within), [&](const SvgLine* seam) {
    return seam->area < cut.area && lies_inside(seam->line.points, cut.line.points);
  });
  if (within.empty()) return nullptr;
  if (size.empty() || others.empty()) return within[0];
  for (const SvgLine* seam : within)
    if (has_words(all_labels(document, *seam->shape), size)) return seam;
  const int own_group = innermost_group(*cut.shape);
  if (std::none_of(others.begin(), others.end(),
                   [&](const SvgLine* other) { return stands_in(*other->shape, own_group); }))
    for (const SvgLine* seam : within)
      if (stands_in(*seam->shape, own_group)) return seam;

  const std::string own = all_labels(document, *cut.shape);
  const auto of_another = [&](const SvgLine* seam) {
    return std::any_of(others.begin(), others.end(), [&](const SvgLine* other) {
      const int group = innermost_group(*other->shape);
      return (stands_in(*seam->shape, group) && !stands_in(*cut.shape, group)) ||
             has_words_of_other(all_labels(document, *seam->shape),
                                all_labels(document, *other->shape), own);
    });
  };
  if (seams.size() == others.size() + 1 && std::none_of(seams.begin(), seams.end(), of_another)) {
    const auto larger = std::count_if(others.begin(), others.end(),
                                      [&](const SvgLine* other) { return other->area > cut.area; });
    const SvgLine* same_place = seams[static_cast<std::size_t>(larger)];
    if (std::find(within.begin(), within.end(), same_place) != within.end()) return same_place;
  }
  within.erase(std::remove_if(within.begin(), within.end(), of_another), within.end());
  if (within.empty()) return nullptr;
  notes.push_back(fmt::format(
      "no label says of which size its sew line is; taken is the largest one that lies in it, {}",
      described(document, *within[0]->shape)));
  return within[0];
}

}  // namespace loosefit::io
