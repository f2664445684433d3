#include "robot/memory/schema_check.h"

#include <set>
#include <string>

#include "robot/memory/schema_pool.h"

namespace robot::memory {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;

/// Returns the type of a field, such as "float" or "repeated foresight.Pose.Particle". Equal types read bytes equally.
std::string type_of(const FieldDescriptor& field) {
  std::string type = field.is_repeated() ? "repeated " : "";
  if (field.type() == FieldDescriptor::TYPE_MESSAGE) return type + field.message_type()->full_name();
  if (field.type() == FieldDescriptor::TYPE_ENUM) return type + field.enum_type()->full_name();
  return type + field.type_name();
}

Result<void> compare(const EnumDescriptor& ours, const EnumDescriptor& theirs) {
  for (int i = 0; i < ours.value_count(); ++i) {
    const auto& value = *ours.value(i);
    const auto* other = theirs.FindValueByName(value.name());
    if (other && other->number() != value.number())
      return Error{"value " + value.name() + " of " + ours.full_name() + ": expected number " +
                   std::to_string(value.number()) + ", got number " + std::to_string(other->number())};
  }
  return {};
}

Result<void> compare(const FieldDescriptor& ours, const FieldDescriptor& theirs) {
  const std::string what = "field " + ours.name() + " of " + ours.containing_type()->full_name();
  if (ours.number() != theirs.number())
    return Error{what + ": expected number " + std::to_string(ours.number()) + ", got number " +
                 std::to_string(theirs.number())};
  if (type_of(ours) != type_of(theirs))
    return Error{what + ": expected type " + type_of(ours) + ", got type " + type_of(theirs)};
  return {};
}

Result<void> compare(const Descriptor& ours, const Descriptor& theirs, std::set<const Descriptor*>& seen) {
  if (!seen.insert(&ours).second) return {};
  for (int i = 0; i < ours.field_count(); ++i) {
    const FieldDescriptor& field = *ours.field(i);
    const FieldDescriptor* same_name = theirs.FindFieldByName(field.name());
    const FieldDescriptor* same_number = theirs.FindFieldByNumber(field.number());
    if (!same_name && same_number)
      return Error{"number " + std::to_string(field.number()) + " of " + ours.full_name() + ": expected field " +
                   field.name() + ", got field " + same_number->name()};
    if (!same_name) continue;
    Result<void> equal = compare(field, *same_name);
    if (equal && field.message_type()) equal = compare(*field.message_type(), *same_name->message_type(), seen);
    if (equal && field.enum_type()) equal = compare(*field.enum_type(), *same_name->enum_type());
    if (!equal) return equal;
  }
  return {};
}

}  // namespace

Result<void> check_readable(const Schema& schema) {
  if (schema.encoding != "protobuf") return {};
  const Result<const Descriptor*> message = SchemaPool().read(schema);
  if (!message) return message.failure();
  return {};
}

Result<void> check_same_meaning(const Descriptor& ours, const Schema& theirs) {
  SchemaPool pool;
  const Result<const Descriptor*> message = pool.read(theirs);
  if (!message) return message.failure();
  std::set<const Descriptor*> seen;
  return compare(ours, **message, seen);
}

}  // namespace robot::memory
