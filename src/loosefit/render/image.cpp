#include "loosefit/render/image.h"

#include <vtkAutoInit.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <mutex>

#include "loosefit/base/error.h"

VTK_MODULE_INIT(vtkRenderingFreeType)

namespace loosefit::render {
namespace {
/// 8-bit value → linear light.
const std::array<float, 256>& linear_light() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (int i = 0; i < 256; ++i) t[i] = static_cast<float>(std::pow(i / 255.0, 2.2));
    return t;
  }();
  return table;
}

/// Linear light → 8-bit value, lround(255 light^(1/2.2)), without a power for every channel of
/// every pixel: between neighbouring floats the power rises by more than its round-off, so each
/// value begins at one float, which is looked for once.
class EightBitValues {
 public:
  EightBitValues() {
    for (int v = 1; v < 256; ++v) begins_[v] = first_float(v);
    for (int bin = 0; bin <= kBins; ++bin) lowest_[bin] = computed(static_cast<float>(bin) / kBins);
  }
  std::uint8_t of(float light) const {
    int value = lowest_[std::min(static_cast<int>(light * kBins), kBins)];
    while (value < 255 && light >= begins_[value + 1]) ++value;
    return static_cast<std::uint8_t>(value);
  }

 private:
  static constexpr int kBins = 4096;
  static std::uint8_t computed(float light) {
    return static_cast<std::uint8_t>(std::lround(255 * std::pow(light, 1 / 2.2)));
  }
  /// Positive floats are in the order of their bits.
  static float first_float(int value) {
    std::uint32_t below = 0, reached = std::bit_cast<std::uint32_t>(1.0f);
    while (reached - below > 1) {
      const std::uint32_t middle = below + (reached - below) / 2;
      (computed(std::bit_cast<float>(middle)) >= value ? reached : below) = middle;
    }
    return std::bit_cast<float>(reached);
  }
  std::array<float, 256> begins_{};
  std::array<std::uint8_t, kBins + 1> lowest_{};
};
}  // namespace

Image scaled_down(const Image& image, int factor) {
  if (factor <= 1) return image;
  Image out(image.width / factor, image.height / factor);
  const auto& light = linear_light();
  static const EightBitValues values;
  const float share = 1.0f / static_cast<float>(factor * factor);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      float sum[3] = {0, 0, 0};
      for (int dy = 0; dy < factor; ++dy)
        for (int dx = 0; dx < factor; ++dx) {
          const Rgb& p = image.at(x * factor + dx, y * factor + dy);
          for (int k = 0; k < 3; ++k) sum[k] += light[p[k]];
        }
      for (int k = 0; k < 3; ++k) out.at(x, y)[k] = values.of(sum[k] * share);
    }
  return out;
}

void fill(Image& image, int x0, int y0, int x1, int y1, Rgb colour) {
  for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y)
    for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x) image.at(x, y) = colour;
}

void draw_text(Image& image, const std::string& text, int x, int y, int size, int align, Rgb colour,
               bool bold) {
  static std::mutex fonts;  // VTK's fonts are one cache for the whole process
  const std::lock_guard lock(fonts);
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetBold(bold);
  property->SetColor(1, 1, 1);
  vtkNew<vtkImageData> raster;
  int size_used[2] = {0, 0};
  if (text.empty() ||
      !vtkTextRenderer::GetInstance()->RenderString(property, text, raster, size_used, 72))
    return;
  const int left = align < 0 ? x : align == 0 ? x - size_used[0] / 2 : x - size_used[0];
  int extent[6];
  raster->GetExtent(extent);
  for (int row = 0; row < size_used[1]; ++row)
    for (int column = 0; column < size_used[0]; ++column) {
      const int px = left + column, py = y + size_used[1] - 1 - row;
      if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
      const auto* rgba = static_cast<const unsigned char*>(
          raster->GetScalarPointer(extent[0] + column, extent[2] + row, extent[4]));
      const int cover = rgba[3];
      for (int k = 0; k < 3; ++k)
        image.at(px, py)[k] = static_cast<std::uint8_t>(
            (image.at(px, py)[k] * (255 - cover) + colour[k] * cover + 127) / 255);
    }
}

namespace {
vtkSmartPointer<vtkImageData> raster_of(const Image& image) {
  vtkSmartPointer<vtkImageData> raster = vtkSmartPointer<vtkImageData>::New();
  raster->SetDimensions(image.width, image.height, 1);
  raster->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(&image.at(0, y)[0], 3 * image.width,
                static_cast<unsigned char*>(raster->GetScalarPointer(0, image.height - 1 - y, 0)));
  return raster;
}
}  // namespace

std::string jpeg(const Image& image) {
  const vtkSmartPointer<vtkImageData> raster = raster_of(image);
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputData(raster);
  writer->SetQuality(82);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void write_png(const std::filesystem::path& path, const Image& image) {
  const vtkSmartPointer<vtkImageData> raster = raster_of(image);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(raster);
  writer->SetCompressionLevel(2);  // a third of the time of the usual 5, a tenth more bytes
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  file.close();
  if (!file) throw IoError(path.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace loosefit::render
