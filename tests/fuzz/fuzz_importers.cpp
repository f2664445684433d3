// Any bytes as a recording of another team or a packet of SSL-Vision. The first byte chooses the reader.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/lab/import/bhuman2009.h"
#include "robot/lab/import/nblog.h"
#include "robot/lab/import/resting_ball.h"
#include "robot/lab/import/spl_labels.h"
#include "robot/lab/import/teamcomm.h"
#include "robot/lab/import/truth_feeds.h"
#include "robot/truth/feeds/ssl_vision.h"

namespace {

struct Swallow final : robot::lab::ImportSink {
  robot::Result<void> message(std::string_view, std::uint64_t, const google::protobuf::Message& value) override {
    volatile std::size_t size = value.ByteSizeLong();
    static_cast<void>(size);
    return {};
  }
};

/// A packet that was read gives places on Earth.
void take_as_packet(std::string_view bytes) {
  robot::truth::SslVision vision({});
  const auto world = vision.take(bytes, ~std::uint64_t{0});
  if (!world || !*world) return;
  const auto far = [](float metres) { return !(std::abs(metres) < 51); };
  if (far((*world)->truth.ball().x()) || far((*world)->truth.ball().y())) __builtin_trap();
  for (const auto& robot : (*world)->truth.robots())
    if (far(robot.x()) || far(robot.y()) || !(std::abs(robot.heading()) < 4)) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  Swallow sink;
  const auto recording_of_2009 = [bytes](robot::lab::ImportSink& to) {
    return robot::lab::import_bhuman2009(bytes, 0, to);
  };
  switch (data[0] % 8) {
    case 0: static_cast<void>(robot::lab::import_with_ball(sink, recording_of_2009)); break;
    case 7: static_cast<void>(robot::lab::import_teamcomm(bytes, 0, sink)); break;
    case 5: static_cast<void>(robot::lab::import_ssl_log(bytes, {}, sink)); break;
    case 4: static_cast<void>(robot::lab::import_truth_csv(bytes, 0, sink)); break;
    case 3: static_cast<void>(robot::lab::import_spl_labels(bytes, 0, sink)); break;
    case 2: static_cast<void>(robot::lab::import_bhuman2009(bytes, 0, sink)); break;
    case 1: static_cast<void>(robot::lab::import_nblog(bytes, 0, sink)); break;
    default: take_as_packet(bytes);
  }
  return 0;
}
