#pragma once
#include "loosefit/garment/attachment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::garment {

/// Index of the attachment's panel. \throws InvalidInput as described at `attach`.
int check_attachment(const Attachment& attachment, const pattern::Pattern& pattern);

}  // namespace loosefit::garment
