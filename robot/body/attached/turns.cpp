#include "robot/body/attached/turns.h"

#include <mutex>

#include "robot/core/clock.h"
#include "robot/core/report.h"

namespace robot::body {

namespace {

void report_second_writer(const std::string& topic, const std::string& second) {
  report(Level::warning, "door",
         topic + ": expected one process to write it, got " + second + " too; it waits until the first one ends");
}

}  // namespace

bool Turns::take(const std::string& topic, const std::string& who, const std::atomic<bool>& given_up) {
  const std::uint64_t patient_until_ns = monotonic_ns() + kSecond;
  bool told = false;
  const std::lock_guard guard(lock_);
  while (!given_up && taken_.contains(topic)) {
    if (told) {
      changed_.wait(lock_);
    } else if (monotonic_ns() < patient_until_ns) {
      changed_.wait_until(lock_, patient_until_ns);
    } else {
      told = true;
      report_second_writer(topic, who);
    }
  }
  return !given_up && taken_.insert(topic).second;
}

void Turns::give_back(const std::string& topic) {
  const std::lock_guard guard(lock_);
  taken_.erase(topic);
  changed_.notify_all();
}

void Turns::wake() {
  const std::lock_guard guard(lock_);
  changed_.notify_all();
}

}  // namespace robot::body
