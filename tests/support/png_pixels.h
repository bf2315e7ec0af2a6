#pragma once
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <filesystem>

#include "loosefit/render/image.h"

namespace loosefit::testing {

/// A PNG file of RGB pixels, as VTK reads it.
inline render::Image png_pixels(const std::filesystem::path& file) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* raster = reader->GetOutput();
  int size[3];
  raster->GetDimensions(size);
  render::Image image(size[0], size[1]);
  if (raster->GetNumberOfScalarComponents() != 3) return {};
  for (int y = 0; y < size[1]; ++y)
    std::copy_n(static_cast<unsigned char*>(raster->GetScalarPointer(0, size[1] - 1 - y, 0)),
                3 * size[0], &image.at(0, y)[0]);
  return image;
}

}  // namespace loosefit::testing
