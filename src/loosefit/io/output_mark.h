#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loosefit::io {

/// Names of files relative to their folder → SHA-256.
using FileDigests = std::map<std::string, std::string>;

/// The file by which a folder is known as an output of ours, and in it every file that is ours.
extern const char* const kOutputMark;  // ".loosefit-output.json"

/// A commit that has begun: what leaves the folder and what comes in its place. With it in the mark
/// every file of ours is known at any instant, whether it is the old one or the new one.
struct PendingCommit {
  std::string kind;
  std::string staging;  ///< the hidden folder, relative to the output: "../.out.writing-7"
  bool first = false;   ///< there was no mark before
  std::set<std::string> outgoing;  ///< into `old` of the hidden folder …
  std::set<std::string> aside;  ///< … but these into `aside_folder` of the output, to stay there
  std::string aside_folder;
  FileDigests incoming;              ///< from `new` of the hidden folder
  std::vector<std::string> made;     ///< folders that come with them, the outer ones first
  std::vector<std::string> removed;  ///< folders that go, the inner ones first
};

/// What kOutputMark holds: JSON with `format`, `version`, `sets` (kind → file → SHA-256), `made`,
/// `folders`, `adopted` and, while files are being replaced, `pending`. Bytes of names outside
/// printable ASCII are written as %XX.
struct OutputMark {
  std::map<std::string, FileDigests> sets;  ///< by the kind of output: "run", "body", …
  /// Kind → name of its last whole output, drawn anew for each: files that are added later or
  /// written again change none. Nothing of outputs of earlier versions.
  std::map<std::string, std::string> made;
  std::set<std::string> folders;  ///< folders that we made
  /// The run was there without a mark, so it holds files of ours that are not in any set.
  bool adopted = false;
  std::optional<PendingCommit> pending;

  bool holds(const std::string& kind) const { return sets.count(kind) > 0; }
  /// Digest of a file of any kind; null when it is not ours.
  const std::string* digest(const std::string& file) const;
  /// Draws the name of a whole output of a kind.
  void name_anew(const std::string& kind);
  /// Makes a file no longer ours.
  void forget(const std::string& file);
  std::string text() const;
};

/// The mark of a folder; nothing where none is.
/// \throws InvalidInput if something else has its name; IoError.
std::optional<OutputMark> read_output_mark(const std::filesystem::path& folder);

}  // namespace loosefit::io
