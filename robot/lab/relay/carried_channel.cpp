#include "robot/lab/relay/carried_channel.h"

#include <utility>

namespace robot::lab {

void CarriedChannel::connected(bool new_run, std::int64_t shift_ns) {
  first_of_connection_ = true;
  if (new_run) theirs_ = 0;
  if (!shift_ || shift_ns != shift_ns_) shift_ = std::make_unique<memory::TimeShift>(info(), shift_ns);
  shift_ns_ = shift_ns;
}

/// Returns whether the message arrived before: the first message of a connection may be the last of the one before.
bool CarriedChannel::is_known(const Arrived& message) const {
  if (message.published) return message.published->sequence <= theirs_;
  return first_of_connection_ && began_ && message.capture_ns == last_.capture_ns && message.bytes == last_.bytes;
}

std::uint64_t CarriedChannel::enter(Arrived message) {
  const bool known = is_known(message);
  first_of_connection_ = false;
  if (known) return 0;
  const memory::VersionPtr newest = to_->newest();
  const std::uint64_t ours = newest ? newest->sequence() : 0;
  // messages before the first one are not lost: they were never subscribed
  const std::uint64_t lost = message.published && began_ ? message.published->sequence - theirs_ - 1 : 0;
  if (message.published) theirs_ = message.published->sequence;
  began_ = true;
  last_ = {.capture_ns = message.capture_ns, .published = message.published, .bytes = {}};
  if (!message.published) last_.bytes = message.bytes;

  const std::uint64_t capture_ns = (*shift_)(message.capture_ns);
  std::string bytes = shift_->moved(std::move(message.bytes), message.capture_ns);
  if (message.published)
    to_->relay(std::move(bytes), capture_ns,
               {.sequence = ours + lost + 1, .publish_ns = (*shift_)(message.published->publish_ns)});
  else
    (void)to_->write_bytes(bytes, capture_ns);  // a raw channel accepts any bytes
  return lost;
}

}  // namespace robot::lab
