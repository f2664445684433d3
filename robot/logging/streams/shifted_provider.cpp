#include "robot/logging/streams/shifted_provider.h"

#include <cassert>

namespace robot::logging {

Result<memory::ChannelInfo> ShiftedInProvider::open() {
  Result<memory::ChannelInfo> info = stream_->open();
  if (info) shift_ = std::make_unique<memory::TimeShift>(*info, by_);
  return info;
}

Result<std::optional<Record>> ShiftedInProvider::read() {
  assert(shift_ && "a stream is opened before it is read");
  Result<std::optional<Record>> record = stream_->read();
  if (!record || !*record) return record;
  Record& message = **record;
  message.bytes = shift_->moved(std::move(message.bytes), message.capture_ns);
  message.capture_ns = (*shift_)(message.capture_ns);
  message.publish_ns = (*shift_)(message.publish_ns);
  return record;
}

Result<void> ShiftedInProvider::seek(std::uint64_t capture_ns) { return stream_->seek(by_.back(capture_ns)); }

}  // namespace robot::logging
