// Messages of derived channels as JSON, decoded with nothing but the schema that is announced.
#pragma once

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/descriptor_database.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "robot/memory/channel.h"

namespace tests {

/// Decodes `bytes` by `schema`. Field names are those of the .proto; absent numbers are 0. Fails the test, and returns
/// null, if the schema or the bytes are damaged, or if the message has a field that the schema does not have.
inline nlohmann::json decoded(const robot::memory::Schema& schema, std::string_view bytes) {
  namespace pb = google::protobuf;
  pb::FileDescriptorSet files;
  if (!files.ParseFromString(schema.bytes)) return ADD_FAILURE() << schema.name << ": the schema is damaged", nullptr;
  pb::SimpleDescriptorDatabase database;
  for (const pb::FileDescriptorProto& file : files.file()) database.Add(file);
  pb::DescriptorPool pool(&database);
  const pb::Descriptor* descriptor = pool.FindMessageTypeByName(schema.name);
  if (!descriptor) return ADD_FAILURE() << schema.name << ": the schema does not have it", nullptr;
  pb::DynamicMessageFactory factory(&pool);
  const std::unique_ptr<pb::Message> message(factory.GetPrototype(descriptor)->New());
  if (!message->ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return ADD_FAILURE() << schema.name << ": the bytes are damaged", nullptr;
  const std::string as_read = message->SerializeAsString();
  message->DiscardUnknownFields();
  EXPECT_EQ(as_read.size(), message->SerializeAsString().size()) << schema.name << ": unknown fields";
  pb::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  std::string text;
  EXPECT_TRUE(pb::util::MessageToJsonString(*message, &text, options).ok());
  return nlohmann::json::parse(text);
}

}  // namespace tests
