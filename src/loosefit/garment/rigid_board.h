#pragma once
#include <string>
#include <vector>

#include "loosefit/garment/attachment.h"
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// Adds a rigid board to a sewn garment: the triangles of its panel whose centroids it covers, or
/// the one at its centre where it is smaller than they are. Triangles that touch an earlier board
/// are left to that; a board that gets none is a mass alone. Masses are the caller's.
void add_rigid_board(Garment& garment, int panel, const std::string& name, const Board& board);

/// \throws InvalidInput, key `attachment NAME.position`, for rigid boards over each other.
void check_rigid_boards(const std::vector<Attachment>& attachments);

}  // namespace loosefit::garment
