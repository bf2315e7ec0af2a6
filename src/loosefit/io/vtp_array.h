#pragma once
#include <string>
#include <vector>

namespace loosefit::io {

/// A named array of a VTP file: `components` doubles per point or per cell.
struct VtpArray {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

}  // namespace loosefit::io
