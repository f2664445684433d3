#include "robot/memory/time_shift.h"

#include <set>
#include <vector>

#include "robot/core/clock.h"

namespace robot::memory {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr std::uint64_t kDayNs = 24 * 3600 * kSecond;

bool may_be_time(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_UINT64 && field.name().ends_with("_ns");
}

bool has_times(const Descriptor& message, std::set<const Descriptor*>& seen) {
  if (!seen.insert(&message).second) return false;
  for (int i = 0; i < message.field_count(); ++i) {
    const FieldDescriptor& field = *message.field(i);
    if (may_be_time(field) || (field.message_type() && has_times(*field.message_type(), seen))) return true;
  }
  return false;
}

bool is_near(std::uint64_t time_ns, std::uint64_t capture_ns) {
  return time_ns + kDayNs > capture_ns && time_ns < capture_ns + kDayNs;
}

}  // namespace

TimeShift::TimeShift(const ChannelInfo& channel, const ClockShift& shift)
    : shift_(shift), schema_(std::make_unique<SchemaPool>()) {
  if (shift.is_none() || channel.message_encoding != "protobuf" || channel.schema.encoding != "protobuf") return;
  const Result<const Descriptor*> message = schema_->read(channel.schema);
  std::set<const Descriptor*> seen;
  if (message && has_times(**message, seen)) prototype_ = factory_.GetPrototype(*message);
}

std::string TimeShift::moved(std::string bytes, std::uint64_t capture_ns) {
  if (!prototype_) return bytes;
  const std::unique_ptr<Message> message(prototype_->New());
  if (!message->ParseFromString(bytes) || !move(*message, capture_ns)) return bytes;
  return message->SerializeAsString();
}

bool TimeShift::move(Message& message, std::uint64_t capture_ns) const {
  const auto& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);  // those that are set
  bool moved = false;
  for (const FieldDescriptor* field : fields) {
    const int count = field->is_repeated() ? reflection.FieldSize(message, field) : 1;
    for (int i = 0; i < count; ++i) {
      if (field->message_type()) {
        moved |= move(field->is_repeated() ? *reflection.MutableRepeatedMessage(&message, field, i)
                                           : *reflection.MutableMessage(&message, field),
                      capture_ns);
      } else if (may_be_time(*field)) {
        const std::uint64_t time_ns = field->is_repeated() ? reflection.GetRepeatedUInt64(message, field, i)
                                                           : reflection.GetUInt64(message, field);
        if (!is_near(time_ns, capture_ns)) continue;
        if (field->is_repeated())
          reflection.SetRepeatedUInt64(&message, field, i, (*this)(time_ns));
        else
          reflection.SetUInt64(&message, field, (*this)(time_ns));
        moved = true;
      }
    }
  }
  return moved;
}

}  // namespace robot::memory
