// A recorder of one robot's memory in a temporary log folder, and a small disk.
#pragma once

#include <gtest/gtest.h>
#include <sys/mount.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "robot/logging/sessions/recorder.h"
#include "robot/memory/memory.h"
#include "tests/support/read_stream.h"
#include "tests/support/temporary_folder.h"

namespace tests {

inline constexpr std::uint64_t kNow = 1'700'000'000 * robot::kSecond;

struct Recording : ::testing::Test {
  Recording() { EXPECT_TRUE(list(memory, channels)); }

  void write_ball(float x) {
    foresight::Ball ball;
    ball.set_x(x);
    memory->ball.write(ball, clock.now_ns());
    clock.set(clock.now_ns() + 33 * robot::kMillisecond);
  }

  std::vector<robot::logging::Record> ball_records(const std::string& session) {
    return read_stream(folder.path() / session / "14.2.ball.mcap");
  }

  const TemporaryFolder folder;
  robot::ManualClock clock{kNow};
  std::shared_ptr<robot::memory::Memory> memory = std::make_shared<robot::memory::Memory>("14/2", clock);
  robot::memory::Channels channels;
  robot::logging::LoggingBoard board;
  robot::logging::SessionStore store{folder.path(), 4'000'000'000};
  robot::logging::Recorder recorder{
      channels, board, store, clock, {.info = {.robot = "14/2", .team = 14, .player = 2, .build = "abc"}}};
};

/// A small disk of its own, if the system allows it.
struct SmallDisk {
  SmallDisk(const std::filesystem::path& where, const char* size, unsigned long flags = 0) : path(where) {
    mounted = mount("tmpfs", path.c_str(), "tmpfs", flags, size) == 0;
  }
  ~SmallDisk() {
    if (mounted) umount2(path.c_str(), MNT_DETACH);
  }
  const std::filesystem::path path;
  bool mounted = false;
};

/// Writes a file of that size, or as much of it as fits.
inline void write_ballast(const std::filesystem::path& path, int megabytes) {
  std::ofstream file(path);
  for (int i = 0; i < megabytes; ++i) file << std::string(1'000'000, 'x') << std::flush;
}

}  // namespace tests
