#include "loosefit/io/pvd_write.h"

#include <fmt/format.h>

#include "loosefit/io/pattern_svg.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {

void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const PvdEntry& entry : entries)
    text += fmt::format(
        "    <DataSet timestep=\"{}\" group=\"\" part=\"0\" name=\"{}\" file=\"{}\"/>\n",
        entry.step, svg_escaped(entry.name), svg_escaped(entry.file.generic_string()));
  write_text_file(path.string(), text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace loosefit::io
