// Messages that were not known when this program was built, as their schemas describe them.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor_database.h>

#include <string>

#include "robot/core/result.h"
#include "robot/memory/channel.h"

namespace robot::memory {

/// The messages of one schema; its descriptors live as long as it does. Used by one thread.
class SchemaPool {
 public:
  /// The message that `schema` names, out of the files that it holds, in any order. Once. An Error if they are no
  /// serialised FileDescriptorSet or do not describe the message.
  Result<const google::protobuf::Descriptor*> read(const Schema& schema);

 private:
  /// Keeps the first complaint instead of printing it.
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
