#pragma once
#include <memory>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/render/garment_lines.h"
#include "loosefit/render/scene.h"

namespace loosefit::render {

/// A garment on a body; only referred to.
struct DrawnDrape {
  const body::Body& body;
  const garment::Garment& garment;
  const std::vector<Vec3>& positions;   ///< of the garment's vertices
  const geometry::TriangleMesh& under;  ///< cloth worn under it; may be empty
  std::vector<LineMark> marked = {};    ///< sensors and leads on it
  /// The dress form (mannequin.h); made where none is given.
  std::shared_ptr<const geometry::TriangleMesh> form = {};
};

/// How a painter draws.
struct PaintOptions {
  int width = 900, height = 1000;  ///< of a picture [pixels]
  int supersampling = 2;           ///< drawn this many times larger, then averaged down
  bool ambient_occlusion = true;   ///< depth in the folds; about half a second per view
  double frame_height = 0;         ///< as SceneContent::frame_height
};

/// What a screen has drawn of a picture. The rest needs no screen, so another thread can do it.
struct UnfinishedPicture {
  Image colours;
  std::shared_ptr<const Image> light;
  double ambient = 0;  ///< as of lit()
  int supersampling = 1;
};

/// The picture, lit and of the size that was asked for.
Image finished(UnfinishedPicture picture);

/// Draws one garment on a neutral grey dress form (render/mannequin.h) from any side, plain or with
/// maps. Shading is drawn once per side and serves every picture of it. One at a time on a screen.
class DrapePainter {
 public:
  /// \throws InvalidInput for another number of positions than the garment has vertices.
  DrapePainter(const Screen& screen, const DrawnDrape& drape, const PaintOptions& options);

  void look(const Camera& from);
  /// Plain cloth with its seams.
  UnfinishedPicture cloth();
  /// The garment seen through, with what is worn under it.
  UnfinishedPicture layers();
  /// Colours by the map's fixed range, NaN grey, no legend. \throws InvalidInput for another number
  /// of values than the garment has vertices.
  UnfinishedPicture map(const maps::PerformanceMap& map);

 private:
  const PaintOptions options_;
  std::size_t vertices_;
  std::shared_ptr<const geometry::TriangleMesh> form_;
  GarmentLines lines_;
  Scene scene_;
  std::shared_ptr<const Image> light_;
};

/// As of scenes.
double frame_height(const DrawnDrape& drape, double aspect, const Camera& from);

}  // namespace loosefit::render
