#include "tests/walk/foreign_walk.h"

#include <dlfcn.h>

#include <algorithm>
#include <string>

namespace robot::nao::walk {

/// One walk of a library.
class ForeignGait final : public Gait {
 public:
  ForeignGait(const ForeignWalk& library, void* walk) : library_(library), walk_(walk) {}
  ~ForeignGait() override { library_.end_(walk_); }

  Legs tick(const Sensors& sensors, const Command& command, double dt) override {
    foresight_walk_sensors from{};
    std::copy(sensors.rate.begin(), sensors.rate.end(), from.rate);
    from.roll = sensors.roll, from.pitch = sensors.pitch;
    for (const Side side : {left, right}) {
      std::copy(sensors.load[side].begin(), sensors.load[side].end(), from.load[side]);
      std::copy(sensors.joints[side].begin(), sensors.joints[side].end(), from.joints[side]);
    }
    const foresight_walk_command wanted{command.forward, command.left, command.turn};
    double targets[2][kLegJoints];
    for (const Side side : {left, right}) std::copy(legs_[side].begin(), legs_[side].end(), targets[side]);
    steps_ = library_.tick_(walk_, &from, &wanted, dt, targets) != 0;
    for (const Side side : {left, right}) std::copy_n(targets[side], kLegJoints, legs_[side].begin());
    return legs_;
  }
  bool steps() const override { return steps_; }

 private:
  const ForeignWalk& library_;
  void* walk_;
  Legs legs_{};
  bool steps_ = false;
};

Result<ForeignWalk> ForeignWalk::load(const std::filesystem::path& library) {
  ForeignWalk walk;
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) return Error{"the library of a walk cannot be loaded: " + std::string(dlerror())};
  walk.library_ = std::shared_ptr<void>(handle, [](void* loaded) { dlclose(loaded); });
  std::string missing;
  const auto find = [&](const char* name, auto& function) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
    if (!function) missing.append(missing.empty() ? "" : ", ").append(name);
  };
  find("foresight_walk_stand", walk.stand_);
  find("foresight_walk_begin", walk.begin_);
  find("foresight_walk_tick", walk.tick_);
  find("foresight_walk_end", walk.end_);
  if (!missing.empty())
    return Error{"the library of a walk " + library.string() + ": expected the functions of foresight_walk.h, lacks " +
                 missing};
  return walk;
}

Legs ForeignWalk::stand() const {
  double angles[2][kLegJoints] = {};
  stand_(angles);
  Legs legs;
  for (const Side side : {left, right}) std::copy_n(angles[side], kLegJoints, legs[side].begin());
  return legs;
}

double ForeignWalk::hip_height() const {
  double angles[2][kLegJoints] = {};
  return stand_(angles);
}

std::unique_ptr<Gait> ForeignWalk::begin() const {
  void* const walk = begin_();
  return walk ? std::make_unique<ForeignGait>(*this, walk) : nullptr;
}

}  // namespace robot::nao::walk
