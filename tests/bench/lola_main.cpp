// Cost of the body `nao`, for `scripts/bench lola`.
//
//   bench_lola frames                 reading a frame of known layout, parsing a frame, composing an answer [us]
//   bench_lola cameras SECONDS FILE   both cameras, 30 times a second each, from a stand-in fed with the picture in FILE
//
// Prints one line of JSON.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/memory/memory.h"
#include "robot/nao/camera/camera_thread.h"
#include "robot/nao/lola/actuators.h"
#include "robot/nao/lola/sensors.h"
#include "tests/support/fake_video.h"
#include "tests/support/lola_frame.h"

namespace {

using namespace robot;
using namespace robot::nao;
using nlohmann::json;

constexpr int kRounds = 200'000;
constexpr std::uint64_t kFrame_ns = kSecond / 30;

/// [us] of processor time for one call.
template <class Call>
double cost_us(int calls, Call&& call) {
  const std::uint64_t start_ns = thread_cpu_ns();
  for (int i = 0; i < calls; ++i) call(i);
  return static_cast<double>(thread_cpu_ns() - start_ns) / 1000 / calls;
}

json frames() {
  // two robots whose numbers all differ
  std::vector<std::string> sent;
  for (int i = 0; i < 64; ++i) {
    Sensors sensors = tests::standing_sensors();
    for (float& position : sensors.position) position += 0.001f * static_cast<float>(i);
    sent.push_back(tests::lola_frame(sensors));
  }
  Sensors sensors;
  float sum = 0;  // so that nothing is left out
  SensorFrames experienced;
  const double in_place = cost_us(kRounds, [&](int i) {
    const std::string& frame = sent[static_cast<std::size_t>(i) % sent.size()];
    static_cast<void>(experienced.size_of_first(frame));
    static_cast<void>(experienced.read(frame, sensors));
    sum += sensors.position[3];
  });
  const double looked_through = cost_us(kRounds / 20, [&](int i) {
    SensorFrames fresh;
    static_cast<void>(fresh.read(sent[static_cast<std::size_t>(i) % sent.size()], sensors));
    sum += sensors.position[3];
  });
  ActuatorFrame answer;
  Actuators actuators;
  const double composed = cost_us(kRounds, [&](int i) {
    actuators.position[3] = static_cast<float>(i);
    sum += static_cast<float>(answer.compose(actuators).back());
  });
  return {{"bytes", sent[0].size()},
          {"in_place_us", in_place},
          {"looked_through_us", looked_through},
          {"composed_us", composed},
          {"sum", sum}};
}

json cameras(double seconds, const std::string& file) {
  Result<std::string> picture = read_file(file, 1'000'000);
  if (!picture) return {{"error", picture.error()}};
  const SessionClock clock;
  memory::Memory memory("14/2", clock);
  std::array<tests::FakeCamera, 2> sources;
  std::array<std::atomic<std::uint64_t>, 2> images{}, first_ns{}, last_ns{};
  {
    std::vector<std::unique_ptr<CameraThread>> threads;
    for (std::size_t i = 0; i < sources.size(); ++i)
      threads.push_back(std::make_unique<CameraThread>("camera", CameraSettings{.device = "stand-in", .turned = i == 0},
                                                       std::make_unique<tests::FakeVideo>(sources[i]),
                                                       i == 0 ? memory.camera_top : memory.camera_bottom, clock,
                                                       [&, i](std::uint64_t capture_ns) {
                                                         if (images[i]++ == 0) first_ns[i] = capture_ns;
                                                         last_ns[i] = capture_ns;
                                                       }));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until they stream
    const std::uint64_t start_ns = monotonic_ns();
    for (std::uint64_t frame = 0; static_cast<double>(frame) < 30 * seconds; ++frame) {
      const std::uint64_t due_ns = start_ns + frame * kFrame_ns;
      if (const std::uint64_t now_ns = monotonic_ns(); now_ns < due_ns)
        std::this_thread::sleep_for(std::chrono::nanoseconds(due_ns - now_ns));
      for (tests::FakeCamera& source : sources) source.deliver(*picture, due_ns);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  json report;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const double span_s = static_cast<double>(last_ns[i] - first_ns[i]) * 1e-9;
    report[i == 0 ? "top" : "bottom"] = {
        {"images", images[i].load()}, {"lost", sources[i].lost}, {"fps", static_cast<double>(images[i] - 1) / span_s}};
  }
  report["delivered"] = static_cast<std::uint64_t>(30 * seconds);
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  json report;
  if (what == "frames") report = frames();
  if (what == "cameras" && argc > 3) report = cameras(std::atof(argv[2]), argv[3]);
  std::printf("%s\n", report.dump().c_str());
  return report.is_null() ? 2 : 0;
}
