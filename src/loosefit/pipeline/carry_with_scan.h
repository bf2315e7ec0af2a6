#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pipeline {

/// The placement of a pattern file belongs to the world of the scan's file: same origin, same axes
/// (GarmentCode: y up; a scan file with z up is the same world turned upright). What moved the scan
/// to our frame moves the panels too. A pattern that would then be beside the person, but is not
/// where it stands, was placed for a body over the origin: it stays, with a warning. "Beside": the
/// boxes round panels and body, seen from above or from the side, have less than half of the
/// pattern's box in common along some axis. Of a pattern that is round the person either way the
/// middle and the directions of its panels tell: where they fit the person over the origin better
/// by 2 cm it stays, too; otherwise it is carried, with a warning when that turns or shifts it.
/// Nothing happens for a body that is no scan.
void carry_with_scan(pattern::Pattern& pattern, const body::Body& body,
                     std::vector<std::string>& warnings);

}  // namespace loosefit::pipeline
