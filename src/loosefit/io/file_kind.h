#pragma once
#include <string>
#include <vector>

namespace loosefit::io {

/// What a file is by its content.
struct FileKind {
  std::string name;    ///< "a DXF file", "a mesh (PLY)", "a motion (BVH)", …; empty: not known
  std::string advice;  ///< how to get from it what is wanted; may be empty
};

/// Name of data that is no text and nothing that is known.
inline constexpr const char* kUnknownBinary = "binary data of a kind that is not known";

/// Tells formats that people take for patterns, bodies, tables and scenarios, in UTF-16 too. Looks
/// at no more than the beginning. GarmentCode patterns, tables and plain text have no name.
FileKind recognise_file(const std::string& bytes);
/// Its name alone.
std::string kind_of_file(const std::string& bytes);

/// What to do about a file whose content nobody here knows, by the ending of its name: projects of
/// apparel programs; empty: that says nothing either.
std::string advice_by_name(const std::string& file);

/// Refuses a file of another kind before its reader meets a first bad letter in it.
/// \param expected  what is read here: "a TOML file"
/// \param read_here  names of kinds that are; files of no known kind always are
/// \param hint  follows the advice of the kind
/// \throws InvalidInput
void refuse_other_kinds(const std::string& bytes, const std::string& file,
                        const std::string& expected, const std::vector<std::string>& read_here = {},
                        const std::string& hint = {});

}  // namespace loosefit::io
