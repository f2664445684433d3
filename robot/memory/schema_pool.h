// Messages that this program learns from their schemas at run time.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor_database.h>

#include <string>

#include "robot/core/result.h"
#include "robot/memory/channel.h"

namespace robot::memory {

/// The messages of one schema. Its descriptors live as long as the pool. Used by one thread.
class SchemaPool {
 public:
  /// Returns the descriptor of the message that `schema` names. The files of the schema may be in any order. Returns an
  /// Error if its bytes are not a serialised FileDescriptorSet or do not describe the message. Call it once.
  Result<const google::protobuf::Descriptor*> read(const Schema& schema);

 private:
  /// A collector that keeps the first complaint; without one protobuf would print them.
  class FirstComplaint final : public google::protobuf::DescriptorPool::ErrorCollector {
   public:
    void AddError(const std::string& file, const std::string& element, const google::protobuf::Message* descriptor,
                  ErrorLocation location, const std::string& message) override;

    std::string text;
  };

  google::protobuf::SimpleDescriptorDatabase files_;
  FirstComplaint complaint_;
  google::protobuf::DescriptorPool pool_{&files_, &complaint_};
};

}  // namespace robot::memory
