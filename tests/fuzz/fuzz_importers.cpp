// Any bytes as a recording of another team. The first byte chooses the importer.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/lab/import/bhuman2009.h"
#include "robot/lab/import/nblog.h"
#include "robot/lab/import/spl_labels.h"

namespace {

struct Swallow final : robot::lab::ImportSink {
  robot::Result<void> message(std::string_view, std::uint64_t, const google::protobuf::Message& value) override {
    volatile std::size_t size = value.ByteSizeLong();
    static_cast<void>(size);
    return {};
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  Swallow sink;
  switch (data[0] % 3) {
    case 2: static_cast<void>(robot::lab::import_bhuman2009(bytes, 0, sink)); break;
    case 1: static_cast<void>(robot::lab::import_nblog(bytes, 0, sink)); break;
    default: static_cast<void>(robot::lab::import_spl_labels(bytes, 0, sink));
  }
  return 0;
}
