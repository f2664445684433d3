#include "robot/app/truth/feed_watch.h"

#include <string>

#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::app {

Result<void> FeedWatch::start() {
  return start_thread(thread_, "SSL-Vision", [this] { run(); });
}

void FeedWatch::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void FeedWatch::run() {
  become_background_thread("truth feed");
  std::string told;  // the last problem: the same one is reported once
  while (!stopping_) {
    Result<truth::TimedTruth> world = feed_.next();
    if (!world) {
      if (world.error() != told) report(Level::warning, "truth", world.error());
      told = world.error();
      continue;
    }
    told.clear();
    world->truth.set_sent_ns(clock_.now_ns());
    world_.write(world->truth, world->capture_ns);
  }
}

}  // namespace robot::app
