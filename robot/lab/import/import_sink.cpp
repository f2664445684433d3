#include "robot/lab/import/import_sink.h"

namespace robot::lab {

Result<void> CountingSink::message(std::string_view object, std::uint64_t capture_ns,
                                   const google::protobuf::Message& value) {
  Result<void> taken = sink_.message(object, capture_ns, value);
  if (taken) ++report_.messages[std::string(object)];
  return taken;
}

}  // namespace robot::lab
