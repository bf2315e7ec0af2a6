#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace loosefit::io {

/// One pair of lines of a DXF text file: a whole number that says what the value is, and the value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< without white space round it
  int line = 0;            ///< of the value, from 1
};

/// The groups from one code 0 up to the next: an entity, or the begin or end of something.
struct DxfRecord {
  std::string_view kind;         ///< value of the code 0: "LINE", "ENDBLK", …
  int line = 0;                  ///< where it stands
  std::vector<DxfGroup> groups;  ///< that follow it

  /// First group of this code; nullptr without one.
  const DxfGroup* find(int code) const;
  std::string text(int code) const;  ///< its value; empty without one
};

/// Walks over a DXF text file (Autodesk, DXF reference, "Group codes in numerical order") record by
/// record. Lines end in LF, CR LF or CR. Keeps a reference to the text.
class DxfRecords {
 public:
  DxfRecords(std::string_view text, std::string file);
  /// The next record; false at the end of the file. \throws InvalidInput naming the line of what is
  /// no group code, of a value that is missing, and of bytes 0, which text has not.
  bool next(DxfRecord& record);
  /// A finite number of at most 1e7; a decimal comma is a point. \throws InvalidInput
  double number(const DxfGroup& group) const;
  /// \throws InvalidInput for what is no whole number.
  int integer(const DxfGroup& group) const;
  [[noreturn]] void fail(int line, const std::string& key, const std::string& found,
                         const std::string& expected, const std::string& hint = {}) const;
  int line() const { return line_; }  ///< that was read last

 private:
  bool next_line(std::string_view& line);
  bool next_group(DxfGroup& group);

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  int line_ = 0;
  DxfGroup ahead_;  ///< the code 0 that ended the record before
  bool has_ahead_ = false;
};

}  // namespace loosefit::io
