#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "loosefit/io/mesh_file.h"

namespace loosefit::mesh_text {

/// Splits text into lines and words and keeps count of the line for error messages.
class Lines {
 public:
  Lines(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {}
  /// Moves to the next line; false at the end.
  bool next();
  std::vector<std::string_view> words() const;
  std::size_t offset() const { return at_; }  ///< of the byte behind the current line
  int number() const { return number_; }
  /// \throws InvalidInput when the word is no finite number below 1e9 in size.
  double number_of(std::string_view word) const;
  long integer_of(std::string_view word) const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  std::string_view text_;
  std::string path_;
  std::string_view line_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// Adds a polygon as a fan of triangles.
void add_polygon(const std::vector<int>& corners, TriangleMesh& mesh);

MeshFile read_obj(std::string_view text, const std::string& path);
MeshFile read_ply(std::string_view bytes, const std::string& path);
MeshFile read_stl(std::string_view bytes, const std::string& path);

}  // namespace loosefit::mesh_text
