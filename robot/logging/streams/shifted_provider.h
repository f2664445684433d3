// A stream from a machine whose clock differs, with its times converted to another clock.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "robot/core/clock_shift.h"
#include "robot/logging/streams/provider.h"
#include "robot/memory/time_shift.h"

namespace robot::logging {

/// The messages of another stream with every time shifted, also the times inside the messages.
class ShiftedInProvider final : public InProvider {
 public:
  ShiftedInProvider(std::unique_ptr<InProvider> stream, const ClockShift& by) : stream_(std::move(stream)), by_(by) {}

  Result<memory::ChannelInfo> open() override;
  Result<std::optional<Record>> read() override;
  Result<void> seek(std::uint64_t capture_ns) override;
  std::uint64_t lost_before() const override { return stream_->lost_before(); }
  void cancel() override { stream_->cancel(); }

 private:
  const std::unique_ptr<InProvider> stream_;
  const ClockShift by_;
  std::unique_ptr<memory::TimeShift> shift_;
};

}  // namespace robot::logging
