#include "loosefit/report/write_body.h"

#include "loosefit/io/body_file.h"
#include "loosefit/io/mesh_obj.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/vtp_write.h"

namespace loosefit::report {

void write_body(const std::filesystem::path& folder, const body::Body& body,
                const body::BodyFit& fit) {
  io::RunFolder files = io::RunFolder::add(folder, "body");
  const auto path = [&](const char* name) { return (files.path() / name).string(); };
  io::write_obj(path("body.obj"), body.surface, body.normals);
  io::write_body_vtp(path("body.vtp"), body);
  io::write_body_json(path("body.json"), body, fit);
  files.commit();
}

}  // namespace loosefit::report
