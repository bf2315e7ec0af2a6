#include "loosefit/render/render_pictures.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <memory>

#include "loosefit/render/drape_painter.h"
#include "loosefit/render/legend.h"

namespace loosefit::render {
namespace {

/// The same picture on a taller sheet with room for the legend.
Image with_foot(const Image& image, int foot) {
  Image sheet(image.width, image.height + foot);
  std::copy(image.pixels.begin(), image.pixels.end(), sheet.pixels.begin());
  return sheet;
}

/// Finishes and writes pictures while the screen draws the next ones.
class FinishingTasks {
 public:
  /// \throws what a task has thrown.
  template <class Task>
  void run(Task task) {
    if (++waiting_ > kMostWaiting) wait();
    group_.run([kept = std::make_shared<Task>(std::move(task))] { (*kept)(); });
  }
  void wait() {
    group_.wait();
    waiting_ = 1;
  }

 private:
  static constexpr int kMostWaiting = 3;  // 9 MB each
  tbb::task_group group_;
  int waiting_ = 0;
};

}  // namespace

std::vector<Picture> render_pictures(const Screen& screen, const std::filesystem::path& dir,
                                     const body::Body& body, const garment::Garment& garment,
                                     const std::vector<Vec3>& positions,
                                     const std::vector<maps::PerformanceMap>& maps,
                                     const PictureOptions& options,
                                     const std::function<void(double)>& after_each) {
  const int foot = options.height / 7;
  DrapePainter painter(screen,
                       {body, garment, positions, options.under, options.marked, options.form},
                       {.width = options.width,
                        .height = options.height - foot,
                        .supersampling = options.supersampling,
                        .ambient_occlusion = options.ambient_occlusion});
  const bool layered = !options.under.triangles.empty();
  std::vector<const maps::PerformanceMap*> drawn;
  for (const maps::PerformanceMap& map : maps)
    if (map.pictured) drawn.push_back(&map);
  const std::size_t count =
      options.views.size() * (drawn.size() + (options.undecorated ? (layered ? 2 : 1) : 0));

  std::vector<Picture> pictures;
  pictures.reserve(count);  // those that are being finished do not move
  FinishingTasks tasks;
  // Tells of the picture and lets another thread write it.
  const auto finish = [&](UnfinishedPicture unfinished, const std::string& map, View view,
                          const maps::PerformanceMap* legend) {
    pictures.push_back({map, view, dir / (map + "-" + name(view) + ".png")});
    tasks.run([&options, &picture = pictures.back(), unfinished = std::move(unfinished), legend,
               foot]() mutable {
      Image image = finished(std::move(unfinished));
      if (legend) {
        image = with_foot(image, foot);
        draw_legend(image, *legend, foot);
      }
      draw_line_names(image, options.marked);
      picture.preview = jpeg(image);
      write_png(picture.file, image);
    });
    if (pictures.size() == count) tasks.wait();
    if (after_each) after_each(static_cast<double>(pictures.size()) / static_cast<double>(count));
  };
  for (View view : options.views) {
    painter.look(camera(view));
    // The plain drape; with other layers also one that is seen through.
    if (options.undecorated) finish(painter.cloth(), "drape", view, nullptr);
    if (options.undecorated && layered) finish(painter.layers(), "layers", view, nullptr);
    // The maps, each with its legend below.
    for (const maps::PerformanceMap* map : drawn)
      finish(painter.map(*map), map->map.empty() ? map->array : map->map, view, map);
  }
  return pictures;
}

}  // namespace loosefit::render
