#include "loosefit/io/output_mark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/io/plain_files.h"
#include "loosefit/io/text_file.h"

namespace loosefit::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "loosefit-output";
constexpr int kVersion = 1;

/// JSON is UTF-8; names of files are bytes.
std::string escaped(const std::string& name) {
  std::string text;
  for (const unsigned char c : name)
    text += c < 0x20 || c > 0x7e || c == '%' ? fmt::format("%{:02X}", c) : std::string(1, char(c));
  return text;
}

std::string unescaped(const std::string& text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    if (i + 2 >= text.size() || !std::isxdigit(static_cast<unsigned char>(text[i + 1])) ||
        !std::isxdigit(static_cast<unsigned char>(text[i + 2])))
      throw InvalidInput("a broken %XX");
    name += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
    i += 2;
  }
  return name;
}

/// A name that stays below its folder: the mark may have been written by anybody.
std::string file_name(const std::string& text) {
  const std::string name = unescaped(text);
  const std::filesystem::path path(name);
  bool inside = !name.empty() && name.find('\0') == std::string::npos && path.is_relative() &&
                name != kOutputMark && path.has_filename();
  for (const auto& part : path) inside = inside && part != ".." && part != ".";
  if (!inside) throw InvalidInput("a name that is not that of a file in this folder");
  return name;
}

Json digests_json(const FileDigests& files) {
  Json json = Json::object();
  for (const auto& [name, digest] : files) json[escaped(name)] = digest;
  return json;
}

FileDigests digests_of(const Json& json) {
  FileDigests files;
  for (const auto& [name, digest] : json.get_ref<const Json::object_t&>()) {
    const std::string& text = digest.get_ref<const std::string&>();
    if (text.size() != 64) throw InvalidInput("a digest of another length");
    files[file_name(name)] = text;
  }
  return files;
}

template <class Names>
Json names_json(const Names& names) {
  Json json = Json::array();
  for (const std::string& name : names) json.push_back(escaped(name));
  return json;
}

template <class Names>
Names names_of(const Json& json) {
  Names names;
  for (const Json& name : json.get_ref<const Json::array_t&>())
    names.insert(names.end(), file_name(name.get_ref<const std::string&>()));
  return names;
}

Json pending_json(const PendingCommit& pending) {
  return {{"kind", escaped(pending.kind)},
          {"staging", escaped(pending.staging)},
          {"first", pending.first},
          {"outgoing", names_json(pending.outgoing)},
          {"aside", names_json(pending.aside)},
          {"aside_folder", escaped(pending.aside_folder)},
          {"incoming", digests_json(pending.incoming)},
          {"made", names_json(pending.made)},
          {"removed", names_json(pending.removed)}};
}

PendingCommit pending_of(const Json& json) {
  PendingCommit pending;
  pending.kind = unescaped(json.at("kind"));
  pending.staging = unescaped(json.at("staging"));
  // One name, here or beside the folder.
  const bool beside = pending.staging.rfind("../", 0) == 0;
  const std::string last = file_name(beside ? json.at("staging").get<std::string>().substr(3)
                                            : json.at("staging").get<std::string>());
  if (last.find('/') != std::string::npos || last.find(".writing-") == std::string::npos)
    throw InvalidInput("a name that is not that of a hidden folder");
  pending.first = json.at("first");
  pending.outgoing = names_of<std::set<std::string>>(json.at("outgoing"));
  pending.aside = names_of<std::set<std::string>>(json.at("aside"));
  if (!pending.aside.empty()) pending.aside_folder = file_name(json.at("aside_folder"));
  pending.incoming = digests_of(json.at("incoming"));
  pending.made = names_of<std::vector<std::string>>(json.at("made"));
  pending.removed = names_of<std::vector<std::string>>(json.at("removed"));
  return pending;
}

OutputMark mark_of(const Json& json) {
  OutputMark mark;
  for (const auto& [kind, files] : json.at("sets").get_ref<const Json::object_t&>())
    mark.sets[unescaped(kind)] = digests_of(files);
  if (json.contains("made"))
    for (const auto& [kind, name] : json.at("made").get_ref<const Json::object_t&>())
      mark.made[unescaped(kind)] = name.get_ref<const std::string&>();
  mark.folders = names_of<std::set<std::string>>(json.at("folders"));
  mark.adopted = json.value("adopted", false);
  if (json.contains("pending")) mark.pending = pending_of(json.at("pending"));
  return mark;
}

}  // namespace

const char* const kOutputMark = ".loosefit-output.json";

const std::string* OutputMark::digest(const std::string& file) const {
  for (const auto& [kind, files] : sets)
    if (const auto found = files.find(file); found != files.end()) return &found->second;
  return nullptr;
}

void OutputMark::name_anew(const std::string& kind) {
  std::random_device draw;
  std::string name;
  for (int k = 0; k < 4; ++k) name += fmt::format("{:08x}", draw());
  made[kind] = name;
}

void OutputMark::forget(const std::string& file) {
  for (auto& [kind, files] : sets) files.erase(file);
}

std::string OutputMark::text() const {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["sets"] = Json::object();
  for (const auto& [kind, files] : sets) json["sets"][escaped(kind)] = digests_json(files);
  for (const auto& [kind, name] : made) json["made"][escaped(kind)] = name;
  json["folders"] = names_json(folders);
  if (adopted) json["adopted"] = true;
  if (pending) json["pending"] = pending_json(*pending);
  return json.dump(1) + "\n";
}

std::optional<OutputMark> read_output_mark(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kOutputMark;
  const auto refuse = [&file](const std::string& found) {
    return InvalidInput({file.string(), 0, ""}, found, "the mark of an output of Loosefit",
                        "nothing was changed; choose another folder with -o");
  };
  const Standing there = standing(folder, kOutputMark);
  if (there == Standing::nothing) return {};
  if (there == Standing::other) throw refuse("something that is not a plain file");
  const Json json = Json::parse(read_text_file(file.string(), 100000000), nullptr, false);
  if (!json.is_object() || !json.contains("format") || json["format"] != kFormat)
    throw refuse("something else");
  if (!json.contains("version") || json["version"] != kVersion)
    throw refuse("the mark of another version of Loosefit");
  try {
    return mark_of(json);
  } catch (const nlohmann::json::exception&) {
    throw refuse("a damaged one");
  } catch (const InvalidInput& error) {
    throw refuse(error.what());
  }
}

}  // namespace loosefit::io
