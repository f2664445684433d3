#include "tests/walk/mujoco_model.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

namespace robot::nao::walk {

Model load_model(const Scene& scene) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  static mjVFS files;  // too large for a stack
  const std::string xml = model_of(scene);
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "nao.xml", static_cast<int>(xml.size()));
  std::memcpy(files.filedata[0], xml.data(), xml.size());
  std::array<char, 1000> problem{};
  Model model(mj_loadXML("nao.xml", &files, problem.data(), problem.size()));
  mj_deleteVFS(&files);
  if (model) return model;
  std::fprintf(stderr, "the model of the Nao: %s\n", problem.data());
  std::abort();
}

}  // namespace robot::nao::walk
