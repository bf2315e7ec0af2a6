#pragma once
#include <string>

#include "loosefit/io/pattern_file.h"
#include "loosefit/io/pieces/piece_panel.h"

namespace loosefit::io {

/// Gathers the pieces of a file that draws them: side by side, mirrored where they are cut for both
/// hands. What cannot be cloth is left out with a warning, optional pieces with a note. Keeps the
/// account of the file: what became of every piece goes to `used` or to `unused`.
class PieceCollector {
 public:
  explicit PieceCollector(PatternFile& result) : result_(result) {}
  /// \param place where it stands in the file, for messages: "block at line 7"
  /// \throws InvalidInput when all pieces together have too many points.
  void add(DrawnPiece drawn, const PieceCount& count, const std::string& place);
  /// Tells in `about` and `warnings` how the pieces were taken.
  /// \param sew_line what the file would call a sew line \throws GeometryError without any piece.
  void finish(const std::string& file, const std::string& sew_line);

 private:
  void warn(const std::string& warning) { result_.warnings.push_back(warning); }
  /// \param names of the panels that were made of it
  void tell(const std::string& place, const PiecePanel& made, const PieceCount& count,
            const std::vector<std::string>& names);
  std::string lay_beside(PiecePanel piece);  ///< \return the name of the panel

  PatternFile& result_;
  double right_ = 0;
  int on_sew_line_ = 0, on_cut_line_ = 0, unfolded_ = 0, twins_ = 0;
  std::size_t points_ = 0;
};

}  // namespace loosefit::io
