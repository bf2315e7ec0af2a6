#pragma once
#include "loosefit/garment/attachment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// Index of the attachment's panel. \throws InvalidInput as described at `attach`.
int check_attachment(const Attachment& attachment, const Pattern& pattern);

}  // namespace loosefit
