#include "robot/memory/schema.h"

#include <google/protobuf/descriptor.pb.h>

#include <set>

namespace robot::memory {
namespace {

using google::protobuf::FileDescriptor;

void add_with_imports(const FileDescriptor& file, std::set<const FileDescriptor*>& seen,
                      google::protobuf::FileDescriptorSet& files) {
  if (!seen.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) add_with_imports(*file.dependency(i), seen, files);
  file.CopyTo(files.add_file());
}

}  // namespace

Schema schema_of(const google::protobuf::Descriptor& message) {
  google::protobuf::FileDescriptorSet files;
  std::set<const FileDescriptor*> seen;
  add_with_imports(*message.file(), seen, files);
  return {.name = message.full_name(), .encoding = "protobuf", .bytes = files.SerializeAsString()};
}

}  // namespace robot::memory
