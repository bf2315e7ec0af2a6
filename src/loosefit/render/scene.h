#pragma once
#include <array>
#include <memory>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/maps/performance_map.h"
#include "loosefit/render/image.h"
#include "loosefit/render/line_mark.h"
#include "loosefit/render/screen.h"
#include "loosefit/render/view.h"

namespace loosefit::render {

/// What stands before the camera.
struct SceneContent {
  const geometry::TriangleMesh& body;
  const std::vector<Vec3>& positions;             ///< garment
  const std::vector<Triangle>& triangles;         ///< garment
  std::vector<std::array<int, 2>> lines;          ///< dark lines on the garment (vertex pairs)
  std::vector<std::array<int, 2>> seams;          ///< thinner lines
  std::vector<LineMark> marked = {};              ///< broad lines in their colours
  const geometry::TriangleMesh* under = nullptr;  ///< cloth between body and garment
  double frame_height = 0;  ///< [m] that a picture shows from foot to top; 0: all fits in
};

/// Height [m] of a picture from this side that all of a scene fits in, `aspect` its width over its
/// height: the largest of several scenes shows them to one scale.
double frame_height(const SceneContent& content, double aspect, const Camera& from);

/// Draws a garment on its mannequin. Light and colour are drawn apart, because
/// shading that is mixed with colours falsifies a map, and because the costly shading then serves
/// every map of a view. Parallel projection, the garment fills the frame.
class Scene {
 public:
  /// One scene at a time on a screen, which outlives it.
  Scene(const Screen& screen, const SceneContent& content, int width, int height, int supersampling,
        bool ambient_occlusion);
  ~Scene();
  void look(const Camera& from);
  void look(View view) { look(camera(view)); }
  /// 1: opaque; less lets body and cloth under the garment be seen through it.
  void set_opacity(double opacity);
  /// Grey light of the scene as if all was white, 0..255; background 255. Not scaled down.
  Image light();
  /// Unlit colours: garment by `map` (plain `cloth` when null), mannequin, lines. Not scaled down.
  Image colours(const maps::PerformanceMap* map, Rgb cloth = {255, 255, 255});

 private:
  struct Window;
  std::unique_ptr<Window> window_;
};

}  // namespace loosefit::render
