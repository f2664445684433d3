// A stream of a session whose folder may be deleted while it is recorded.
#pragma once

#include <atomic>
#include <memory>

#include "robot/logging/streams/provider.h"

namespace robot::logging {

/// Wraps `stream` so that it makes no file after `gone` was set: its folder was deleted, or another one has its path. A
/// stream that is open already goes on. Otherwise each stream without a message would report the same failure.
std::unique_ptr<OutProvider> unless_gone(std::shared_ptr<const std::atomic<bool>> gone,
                                         std::unique_ptr<OutProvider> stream);

}  // namespace robot::logging
