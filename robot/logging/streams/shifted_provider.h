// A stream from a machine whose clock differs, with its times converted to another clock.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "robot/logging/streams/provider.h"
#include "robot/memory/time_shift.h"

namespace robot::logging {

/// The messages of another stream with every time shifted, also the times inside the messages.
class ShiftedInProvider final : public InProvider {
 public:
  /// Adds `by_ns` to every time.
  ShiftedInProvider(std::unique_ptr<InProvider> stream, std::int64_t by_ns)
      : stream_(std::move(stream)), by_ns_(by_ns) {}

  Result<memory::ChannelInfo> open() override;
  Result<std::optional<Record>> read() override;
  Result<void> seek(std::uint64_t capture_ns) override;
  std::uint64_t lost_before() const override { return stream_->lost_before(); }
  void cancel() override { stream_->cancel(); }

 private:
  const std::unique_ptr<InProvider> stream_;
  const std::int64_t by_ns_;
  std::unique_ptr<memory::TimeShift> shift_;
};

}  // namespace robot::logging
