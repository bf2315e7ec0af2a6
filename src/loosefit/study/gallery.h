#pragma once
#include <string>

#include "loosefit/base/progress.h"
#include "loosefit/study/study_folder.h"

namespace loosefit::study {

/// What of a study can be looked at.
struct Gallery {
  std::string png;  ///< bytes of the picture; empty: none
  std::string why;  ///< why there is none; empty where no output was kept either
  int cases = 0;    ///< in the picture
};

/// The drapes of all cases that have scores and whose whole output was kept (--keep-output), from
/// the front, to one scale, with the distance from the body in one range; in the order of the
/// cases, as many beside each other as the last axis has levels. A case without a picture leaves no
/// gap; captions tell which is which. At most kMostPictures. \throws Cancelled.
Gallery make_gallery(const StudyFolder& folder, const FolderPlan& plan, Progress& progress);

inline constexpr int kMostPictures = 120;

}  // namespace loosefit::study
