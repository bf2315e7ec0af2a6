#include "loosefit/validate/write_validation.h"

#include "loosefit/io/text_file.h"
#include "loosefit/validate/validation_json.h"
#include "loosefit/validate/validation_page.h"

namespace loosefit::validate {

ValidationOutput::ValidationOutput(const std::filesystem::path& folder)
    : folder_(io::RunFolder::create(folder, "validation")) {
  folder_.announce({"validation.json", "validation.html"});
}

void ValidationOutput::write(const Validation& validation, Progress& progress) {
  io::write_text_file((folder_.path() / "validation.json").string(), validation_json(validation));
  io::write_text_file((folder_.path() / "validation.html").string(), validation_html(validation));
  progress.check_cancelled();
  folder_.commit();
}

}  // namespace loosefit::validate
