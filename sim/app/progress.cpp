#include "sim/app/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace sim::app {

ProgressBar::ProgressBar(std::string what, std::uint64_t all)
    : what_(std::move(what)), all_(all), shown_(all > 0 && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::at(std::uint64_t done) {
  constexpr int kWidth = 40;
  const int percent = shown_ ? static_cast<int>(100 * done / all_) : -1;
  if (percent <= percent_) return;
  percent_ = percent;
  const int full = kWidth * percent / 100;
  std::fprintf(stderr, "\r%s [%s%s] %3d %%", what_.c_str(), std::string(static_cast<std::size_t>(full), '#').c_str(),
               std::string(static_cast<std::size_t>(kWidth - full), ' ').c_str(), percent);
  std::fflush(stderr);
}

}  // namespace sim::app
