#include "loosefit/render/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include "loosefit/render/colour_table.h"
#include "loosefit/render/lit.h"

namespace loosefit::render {
namespace {
constexpr Rgb kMannequin = {176, 176, 176};
constexpr Rgb kUnder = {150, 166, 200};
constexpr Rgb kLine = {35, 35, 35};
constexpr double kMarkRadius = 0.0022, kRimRadius = 0.0034;  // of marked lines [m]
constexpr double kRimNearer = 0.001, kMarkNearer = 0.004;    // and how far before the cloth [m]
constexpr double kMargin = 1.06;           // picture frame over extent of garment and form
constexpr double kOcclusionRadius = 0.05;  // [m], about the size of a fold

vtkNew<vtkPoints> points_of(const std::vector<Vec3>& positions) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), positions[i].data());
  return points;
}

void set_surface(vtkPolyData* data, const std::vector<Vec3>& positions,
                 const std::vector<Triangle>& triangles) {
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : triangles)
    cells->InsertNextCell({vtkIdType{t[0]}, vtkIdType{t[1]}, vtkIdType{t[2]}});
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const Vec3& n : geometry::vertex_normals(positions, triangles))
    normals->InsertNextTuple(n.data());
  data->SetPoints(points_of(positions));
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
}

void set_colour(vtkActor* actor, const Rgb& c) {
  actor->GetProperty()->SetColor(c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
}

/// sin and cos of degrees, exact at quarters of a turn, so that the four views are.
Vec2 sine_and_cosine(double degrees) {
  const double quarters = degrees / 90, whole = std::round(quarters);
  const double rest = (quarters - whole) * kPi / 2;
  const Vec2 turned(std::sin(rest), std::cos(rest));
  switch ((static_cast<int>(whole) % 4 + 4) % 4) {
    case 1:
      return {turned.y(), -turned.x()};
    case 2:
      return -turned;
    case 3:
      return {-turned.y(), turned.x()};
    default:
      return turned;
  }
}

Vec3 towards_camera(const Camera& camera) {
  const Vec2 around = sine_and_cosine(camera.azimuth), above = sine_and_cosine(camera.elevation);
  return {around.x() * above.y(), -around.y() * above.y(), above.x()};
}

/// Of everything in a scene.
Eigen::AlignedBox3d box_of(const SceneContent& content) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : content.positions) box.extend(p);
  for (const Vec3& p : content.body.vertices) box.extend(p);
  if (content.under)
    for (const Vec3& p : content.under->vertices) box.extend(p);
  return box.isEmpty() ? Eigen::AlignedBox3d(Vec3::Zero().eval()) : box;
}

/// One scale for all sides, so that pictures of a garment can be laid beside each other; from above
/// or below its depth takes height, too.
double fitting_height(const Vec3& size, double aspect, const Vec3& back) {
  const double across = std::max(size.x(), size.y());
  const double rise = std::abs(back.z()) * across + back.head<2>().norm() * size.z();
  return kMargin * std::max(rise, across / aspect);
}
}  // namespace

struct Scene::Window {
  /// A surface or a set of lines with its mapper.
  struct Part {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
    void connect() {
      mapper->SetInputData(data);
      mapper->ScalarVisibilityOff();
      actor->SetMapper(mapper);
    }
  };
  vtkRenderWindow* window = nullptr;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLight> key, fill_light;
  Part body, under, garment, lines, seams;
  std::vector<std::unique_ptr<Part>> marked;  ///< a white rim, then the line, of each
  Eigen::AlignedBox3d box;
  Vec2 reach = Vec2::Zero();  ///< largest |x|, |y| of body and garment
  double frame_height = 0;    ///< as SceneContent::frame_height
  int width = 0, height = 0, supersampling = 1;
  bool ambient_occlusion = false;

  void add_lines(Part& part, const std::vector<Vec3>& positions,
                 const std::vector<std::array<int, 2>>& edges, double pixels) {
    vtkNew<vtkCellArray> cells;
    for (const auto& e : edges) cells->InsertNextCell({vtkIdType{e[0]}, vtkIdType{e[1]}});
    part.data->SetPoints(points_of(positions));
    part.data->SetLines(cells);
    part.connect();
    part.mapper->SetResolveCoincidentTopologyToPolygonOffset();
    part.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -4);
    part.actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
    part.actor->GetProperty()->LightingOff();
    set_colour(part.actor, kLine);
    renderer->AddActor(part.actor);
  }

  /// A line on the cloth as a tube; look() brings it before cloth and seams.
  void add_mark(const std::vector<Vec3>& points, Rgb colour, double radius) {
    vtkNew<vtkCellArray> cell;
    cell->InsertNextCell(static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      cell->InsertCellPoint(static_cast<vtkIdType>(i));
    vtkNew<vtkPolyData> line;
    line->SetPoints(points_of(points));
    line->SetLines(cell);
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputData(line);
    tube->SetRadius(radius);
    tube->SetNumberOfSides(8);
    tube->CappingOn();
    tube->Update();
    Part& part = *marked.emplace_back(std::make_unique<Part>());
    part.data->ShallowCopy(tube->GetOutput());
    part.connect();
    part.actor->GetProperty()->LightingOff();
    set_colour(part.actor, colour);
    renderer->AddActor(part.actor);
  }

  void set_lit(Part& part, bool lit) {
    vtkProperty* p = part.actor->GetProperty();
    p->SetLighting(lit);
    p->SetAmbient(lit ? kSceneAmbient : 1);
    p->SetDiffuse(lit ? 1 - kSceneAmbient : 0);
    p->SetSpecular(0);
    if (lit) p->SetColor(1, 1, 1);
  }

  Image draw() { return draw(width, height); }
  Image draw(int across, int down) {
    window->SetSize(across, down);
    window->Render();
    vtkNew<vtkUnsignedCharArray> raw;
    window->GetPixelData(0, 0, across - 1, down - 1, 0, raw);
    Image image(across, down);
    for (int y = 0; y < down; ++y)
      std::copy_n(raw->GetPointer(vtkIdType{3} * across * (down - 1 - y)), 3 * across,
                  &image.at(0, y)[0]);
    return image;
  }
};

Scene::Scene(const Screen& screen, const SceneContent& content, int width, int height,
             int supersampling, bool ambient_occlusion)
    : window_(std::make_unique<Window>()) {
  Window& w = *window_;
  w.window = screen.window();
  w.width = width * supersampling;
  w.height = height * supersampling;
  w.supersampling = supersampling;
  w.ambient_occlusion = ambient_occlusion;
  // Off-screen, on white, lit by our own two lights only.
  w.window->SetOffScreenRendering(1);
  w.window->SetMultiSamples(0);
  w.window->SetSize(w.width, w.height);
  w.renderer->SetBackground(1, 1, 1);
  w.renderer->SetAutomaticLightCreation(0);
  w.window->AddRenderer(w.renderer);

  // Surfaces and the lines on them.
  set_surface(w.body.data, content.body.vertices, content.body.triangles);
  if (content.under) set_surface(w.under.data, content.under->vertices, content.under->triangles);
  set_surface(w.garment.data, content.positions, content.triangles);
  for (Window::Part* part : {&w.body, &w.under, &w.garment}) {
    part->connect();
    w.renderer->AddActor(part->actor);
  }
  w.garment.mapper->InterpolateScalarsBeforeMappingOn();
  w.add_lines(w.lines, content.positions, content.lines, 2.0 * supersampling);
  w.add_lines(w.seams, content.positions, content.seams, 1.2 * supersampling);
  for (std::size_t i = 0; i < content.marked.size(); ++i) {
    w.add_mark(content.marked[i].points, {255, 255, 255}, kRimRadius);
    w.add_mark(content.marked[i].points, line_colour(i), kMarkRadius);
  }

  for (vtkLight* light : {w.key.Get(), w.fill_light.Get()}) {
    light->SetLightTypeToCameraLight();
    w.renderer->AddLight(light);
  }
  // Camera frame: x right, y up, z towards the camera. Grazing light from above shows folds.
  w.key->SetPosition(-0.5, 0.8, 0.9);
  w.key->SetIntensity(0.8);
  w.fill_light->SetPosition(0.6, -0.1, 1.0);
  w.fill_light->SetIntensity(0.42);

  // Extents of body and cloth, for the frame of the pictures.
  for (const Vec3& p : content.body.vertices) w.reach = w.reach.cwiseMax(p.head<2>().cwiseAbs());
  for (const Vec3& p : content.positions) w.reach = w.reach.cwiseMax(p.head<2>().cwiseAbs());
  w.box = box_of(content);
  w.frame_height = content.frame_height;
}

Scene::~Scene() { window_->window->RemoveRenderer(window_->renderer); }

double frame_height(const SceneContent& content, double aspect, const Camera& from) {
  return fitting_height(box_of(content).sizes(), aspect, towards_camera(from));
}

void Scene::look(const Camera& from) {
  Window& w = *window_;
  const Vec3 back = towards_camera(from);
  const Vec3 size = w.box.sizes();
  // From as near as possible: ambient occlusion keeps positions relative to the eye in half
  // precision, and contour lines of that rounding would show on the cloth.
  const double near = 0.1 + back.cwiseAbs().dot(Vec3(w.reach.x(), w.reach.y(), 0.5 * size.z()));
  Vec3 centre = w.box.center();
  const Vec3 level(back.x(), back.y(), 0);  // never zero: Camera::kLargestElevation
  centre -= centre.dot(level.normalized()) * level.normalized();
  const Vec3 eye = centre + near * back;
  vtkCamera* camera = w.renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0, 0, 1);
  const double fitting = fitting_height(size, static_cast<double>(w.width) / w.height, back);
  camera->SetParallelScale(0.5 * (w.frame_height > 0 ? w.frame_height : fitting));
  // Along the line of sight, which moves nothing in the picture; each line before its rim.
  for (std::size_t i = 0; i < w.marked.size(); ++i) {
    const Vec3 nearer = (i % 2 == 0 ? kRimNearer : kMarkNearer) * back;
    w.marked[i]->actor->SetPosition(nearer.x(), nearer.y(), nearer.z());
  }
  w.renderer->ResetCameraClippingRange();
}

void Scene::set_opacity(double opacity) {
  window_->garment.actor->GetProperty()->SetOpacity(opacity);
}

Image Scene::light() {
  Window& w = *window_;
  w.garment.mapper->ScalarVisibilityOff();
  for (Window::Part* part : {&w.body, &w.under, &w.garment}) w.set_lit(*part, true);
  w.lines.actor->VisibilityOff();
  w.seams.actor->VisibilityOff();
  for (const auto& part : w.marked) part->actor->VisibilityOff();
  w.renderer->SetUseSSAO(false);
  Image light = w.draw();
  if (!w.ambient_occlusion) return light;
  // Occlusion is smooth: it is drawn in the size of the finished picture, in white alone.
  for (Window::Part* part : {&w.body, &w.under, &w.garment}) {
    part->actor->GetProperty()->SetAmbient(1);  // lit all the same: occlusion asks for normals
    part->actor->GetProperty()->SetDiffuse(0);
  }
  w.renderer->SetUseSSAO(true);
  w.renderer->SetSSAORadius(kOcclusionRadius);
  w.renderer->SetSSAOBias(0.002);
  w.renderer->SetSSAOKernelSize(64);
  w.renderer->SSAOBlurOn();
  const Image open = w.draw(w.width / w.supersampling, w.height / w.supersampling);
  w.renderer->SetUseSSAO(false);
  for (int y = 0; y < light.height; ++y)
    for (int x = 0; x < light.width; ++x) {
      const int share = open.at(x / w.supersampling, y / w.supersampling)[1];
      for (std::uint8_t& channel : light.at(x, y))
        channel = static_cast<std::uint8_t>(channel * share / 255);
    }
  return light;
}

Image Scene::colours(const maps::PerformanceMap* map, Rgb cloth) {
  Window& w = *window_;
  for (Window::Part* part : {&w.body, &w.under, &w.garment}) w.set_lit(*part, false);
  w.lines.actor->VisibilityOn();
  w.seams.actor->VisibilityOn();
  for (const auto& part : w.marked) part->actor->VisibilityOn();
  set_colour(w.body.actor, kMannequin);
  set_colour(w.under.actor, kUnder);
  set_colour(w.garment.actor, cloth);
  if (map) {
    vtkNew<vtkDoubleArray> scalars;
    scalars->SetName(map->array.c_str());
    const bool broken = !map->breaks.empty();  // then the place on the bar is what is drawn
    for (double value : map->values)
      scalars->InsertNextValue(broken ? colour_share(*map, value) : value);
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(256);
    table->SetTableRange(broken ? 0 : map->range_low, broken ? 1 : map->range_high);
    const ColourTable& colours = colours_of(*map);
    for (int i = 0; i < 256; ++i)
      table->SetTableValue(i, colours[i][0] / 255.0, colours[i][1] / 255.0, colours[i][2] / 255.0);
    table->SetNanColor(kUndefinedColour[0] / 255.0, kUndefinedColour[1] / 255.0,
                       kUndefinedColour[2] / 255.0, 1);
    w.garment.data->GetPointData()->SetScalars(scalars);
    w.garment.mapper->SetLookupTable(table);
    w.garment.mapper->UseLookupTableScalarRangeOn();
    w.garment.mapper->ScalarVisibilityOn();
  } else {
    w.garment.mapper->ScalarVisibilityOff();
  }
  return w.draw();
}

}  // namespace loosefit::render
