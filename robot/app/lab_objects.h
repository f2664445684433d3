// The objects that the lab's process writes about itself. All other channels come from robots and recordings.
#pragma once

#include <memory>

#include "proto/foresight/runtime.pb.h"
#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory_object.h"

namespace robot::app {

/// Statistics, clock samples and log text of the lab's process, under the name "lab/1".
struct LabObjects {
  explicit LabObjects(const Clock& clock) {
    runtime.announce("/lab/1/runtime", memory::Delivery::latest, clock);
    clock_sample.announce("/lab/1/clock", memory::Delivery::reliable, clock);
    log.announce("/lab/1/log", memory::Delivery::reliable, clock);
  }

  memory::MemoryObject<foresight::RuntimeStatistics> runtime;
  memory::MemoryObject<foresight::ClockSample> clock_sample;
  memory::MemoryObject<foresight::LogText> log;
};

/// Adds these objects to `channels`, which then keeps them alive. Returns an Error if a topic is taken.
inline Result<void> list(const std::shared_ptr<LabObjects>& own, memory::Channels& channels) {
  for (memory::Channel* channel : std::initializer_list<memory::Channel*>{&own->runtime, &own->clock_sample, &own->log})
    if (Result<void> listed = channels.add({own, channel}); !listed) return listed;
  return {};
}

}  // namespace robot::app
