#include "robot/core/report.h"

#include <cstdio>
#include <mutex>
#include <utility>

#include "robot/core/lock.h"

namespace robot {
namespace {

Mutex listener_lock;
std::function<void(const Report&)> listener;

Mutex throttle_lock;

const char* name(Level level) {
  switch (level) {
    case Level::debug: return "debug";
    case Level::info: return "info";
    case Level::warning: return "warning";
    case Level::error: return "error";
  }
  return "?";
}

}  // namespace

void report(Level level, std::string_view source, std::string_view sentence) {
  std::fprintf(stderr, "%s: %.*s: %.*s\n", name(level), static_cast<int>(source.size()), source.data(),
               static_cast<int>(sentence.size()), sentence.data());
  const std::lock_guard guard(listener_lock);
  if (listener) listener({level, std::string(source), std::string(sentence)});
}

void set_report_listener(std::function<void(const Report&)> new_listener) {
  const std::lock_guard guard(listener_lock);
  listener = std::move(new_listener);
}

void Throttle::report(Level level, std::string_view source, std::string_view sentence, std::uint64_t now_ns) {
  std::uint64_t left_out = 0;
  {
    const std::lock_guard guard(throttle_lock);
    if (last_ns_ != 0 && now_ns - last_ns_ < kSecond) {
      ++left_out_;
      return;
    }
    last_ns_ = now_ns;
    left_out = std::exchange(left_out_, 0);
  }
  if (left_out == 0) return robot::report(level, source, sentence);
  robot::report(level, source, std::string(sentence) + " (and " + std::to_string(left_out) + " more like it)");
}

}  // namespace robot
