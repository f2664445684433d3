// An object that Foresight does not know, written from C++ for each ball that is read: it is logged, streamed and shown
// like any other. Ends after the given number of seconds.
#include <foresight.h>
#include <foresight_fields.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

namespace {

using Writer = std::unique_ptr<ForesightWriter, decltype(&foresight_close)>;
using Reader = std::unique_ptr<ForesightReader, decltype(&foresight_end)>;

/// Returns the distance to the ball [m] of a foresight.Ball.
double distance_of(const ForesightMessage& message) {
  float x = 0, y = 0;
  ForesightField field = foresight_fields(message.bytes, message.size);
  while (foresight_next_field(&field)) {
    if (field.number == 2) x = foresight_float(&field);
    if (field.number == 3) y = foresight_float(&field);
  }
  return std::hypot(x, y);
}

}  // namespace

int main(int argc, char** argv) {
  ForesightObject object{};
  object.topic = "vortex";
  object.type = "team.Vortex";
  object.message_encoding = "json";
  object.delivery = FORESIGHT_FIFO;
  const Writer vortex(foresight_announce_as(&object, nullptr), &foresight_close);
  const Reader ball(foresight_want("ball"), &foresight_end);

  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(argc > 1 ? std::atof(argv[1]) : 10);
  unsigned long read = 0;
  while (std::chrono::steady_clock::now() < end) {
    foresight_wait(ball.get(), 100);
    ForesightMessage message;
    if (!foresight_read_newest(ball.get(), &message)) continue;
    ++read;
    const std::string json = "{\"distance\": " + std::to_string(distance_of(message)) + "}";
    // a value computed from the ball has the capture time of the ball
    foresight_write(vortex.get(), message.capture_ns, json.data(), json.size());
  }
  std::printf("%lu balls; lost: %lu %s\n", read, static_cast<unsigned long>(foresight_lost(vortex.get())),
              foresight_problem(vortex.get()));
}
