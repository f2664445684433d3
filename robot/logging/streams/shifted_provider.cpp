#include "robot/logging/streams/shifted_provider.h"

#include <cassert>

namespace robot::logging {

Result<memory::ChannelInfo> ShiftedInProvider::open() {
  Result<memory::ChannelInfo> info = stream_->open();
  if (info) shift_ = std::make_unique<memory::TimeShift>(*info, by_ns_);
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

Result<void> ShiftedInProvider::seek(std::uint64_t capture_ns) {
  // a time before 0 of the other clock means the beginning of the stream
  const auto theirs_ns = static_cast<std::int64_t>(capture_ns) - by_ns_;
  return stream_->seek(theirs_ns < 0 ? 0 : static_cast<std::uint64_t>(theirs_ns));
}

}  // namespace robot::logging
