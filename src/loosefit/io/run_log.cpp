#include "loosefit/io/run_log.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/error.h"

namespace loosefit::io {

RunLog::RunLog(const std::filesystem::path& file, Progress& shown)
    : file_(file), stream_(std::fopen(file.c_str(), "w"), &std::fclose), shown_(&shown) {
  if (!stream_) throw IoError(file.string() + ": cannot be written: " + std::strerror(errno));
}

void RunLog::stage(const std::string& name) {
  write("stage", name);
  shown_->stage(name);
}

void RunLog::update(double fraction, const std::string& note) {
  if (Clock::now() - last_note_ > std::chrono::milliseconds(250)) {
    last_note_ = Clock::now();
    write("progress", fmt::format("{:.0f} % {}", 100 * fraction, note));
  }
  shown_->update(fraction, note);
}

void RunLog::end(const std::string& text) {
  write("end", text);
  if (std::ferror(stream_.get()) || std::fclose(stream_.release()) != 0)
    throw IoError(file_.string() + ": cannot be written: " + std::strerror(errno));
}

void RunLog::write(const std::string& event, const std::string& text) {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  nlohmann::ordered_json line;
  line["seconds"] = std::round(seconds * 1000) / 1000;
  line["event"] = event;
  line["text"] = text;
  const std::string dumped =
      json_without_controls(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) +
      "\n";
  std::fwrite(dumped.data(), 1, dumped.size(), stream_.get());
}

}  // namespace loosefit::io
