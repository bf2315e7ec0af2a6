#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/render/line_mark.h"
#include "loosefit/render/screen.h"
#include "loosefit/render/view.h"

namespace loosefit::render {

/// Size and quality of the pictures.
struct PictureOptions {
  int width = 900, height = 1000;  ///< [pixels]
  int supersampling = 2;           ///< drawn this many times larger, then averaged down
  bool ambient_occlusion = true;   ///< depth in the folds; about half a second per picture
  std::vector<View> views = {View::front, View::back};
  bool undecorated = true;       ///< also the plain drape: drape-<view>.png
  geometry::TriangleMesh under;  ///< cloth worn under the garment, in a colour of its own
  /// The dress form of body and garment (mannequin.h); made where none is given.
  std::shared_ptr<const geometry::TriangleMesh> form = {};
  std::vector<LineMark> marked;  ///< sensors and leads on the garment, with their names
};

/// One written picture.
struct Picture {
  std::string map;  ///< PerformanceMap::map, or "drape" and "layers" for the undecorated ones
  View view = View::front;
  std::filesystem::path file;
  std::string preview = {};  ///< the same as JPEG, for a page: a fifth of the bytes; may be empty
};

/// Draws the drape with every map whose `pictured` is set and writes DIR/<map>-<view>.png. The body
/// is a neutral grey dress form (render/mannequin.h); colours are fixed by each map's range; NaN is
/// grey. Cloth worn under the garment is drawn too, and with `undecorated` also through the
/// garment: layers-<view>.png. `after_each` is called with the share done and may throw to stop.
/// \throws IoError when a file cannot be written.
std::vector<Picture> render_pictures(const Screen& screen, const std::filesystem::path& dir,
                                     const body::Body& body, const garment::Garment& garment,
                                     const std::vector<Vec3>& positions,
                                     const std::vector<maps::PerformanceMap>& maps,
                                     const PictureOptions& options = {},
                                     const std::function<void(double)>& after_each = nullptr);

}  // namespace loosefit::render
