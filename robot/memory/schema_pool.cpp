#include "robot/memory/schema_pool.h"

#include <google/protobuf/descriptor.pb.h>

#include <set>

namespace robot::memory {

void SchemaPool::FirstComplaint::AddError(const std::string& file, const std::string& element,
                                          const google::protobuf::Message* /*descriptor*/, ErrorLocation /*location*/,
                                          const std::string& message) {
  if (text.empty()) text = file + ": " + element + ": " + message;
}

Result<const google::protobuf::Descriptor*> SchemaPool::read(const Schema& schema) {
  google::protobuf::FileDescriptorSet set;
  if (!set.ParseFromString(schema.bytes))
    return Error{"schema of " + schema.name + ": expected a serialised FileDescriptorSet, got " +
                 std::to_string(schema.bytes.size()) + " bytes of something else"};
  std::set<std::string> names;  // checked here because the database would print a message about a second one to stderr
  for (const auto& file : set.file())
    if (!names.insert(file.name()).second || !files_.Add(file))
      return Error{"schema of " + schema.name + ": expected every file and every name once, got " + file.name() +
                   " again"};
  const google::protobuf::Descriptor* message = pool_.FindMessageTypeByName(schema.name);
  if (message) return message;
  return Error{"schema of " + schema.name + ": expected a description of that message with all it imports, got " +
               (complaint_.text.empty() ? std::to_string(set.file_size()) + " files without it" : complaint_.text)};
}

}  // namespace robot::memory
