// The Nao as MuJoCo reads it.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "tests/walk/nao_model.h"

namespace robot::nao::walk {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, Deleter>;
using Data = std::unique_ptr<mjData, Deleter>;

/// Reads model_of(scene). One thread at a time.
Model load_model(const Scene& scene);

}  // namespace robot::nao::walk
