// The true path of a drive beside the path that a model predicts.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/walking/drives.h"
#include "robot/fit/walking/mean_walk.h"

namespace robot::fit {

inline constexpr std::size_t kBlockTicks = 10;      // a third of a second
inline constexpr double kBlockDuration = 10. / 30;  // [s]
inline constexpr std::size_t kBlocksASecond = 3;

/// A mean over the places of one block: its error is smaller than that of a place.
struct BlockMean {
  double x = 0, y = 0, heading = 0;  // [m, m, rad, field]
};

/// A drive, prepared for many predictions. The first blocks, which are not settled, are left out.
class DriveTrack {
 public:
  /// `drive` outlives the track.
  explicit DriveTrack(const Drive& drive);

  const Drive& drive() const { return drive_; }
  std::size_t blocks() const { return seen_.size(); }
  /// Returns the number of true places in a block. With fewer than two its mean does not count.
  std::size_t places_in(std::size_t block) const { return counts_[block]; }
  const BlockMean& seen(std::size_t block) const { return seen_[block]; }
  /// Returns the robot's true heading in the middle of a block, as its cosine and sine.
  double cosine(std::size_t block) const { return cosines_[middle_of(block)]; }
  double sine(std::size_t block) const { return sines_[middle_of(block)]; }
  /// Returns the tick in the middle of a block.
  std::size_t middle_of(std::size_t block) const { return drive_.settled + block * kBlockTicks + kBlockTicks / 2; }

  /// Returns the means of the path with these rates in each tick, `late` seconds later, from any start. It follows the
  /// true heading, so that an error of the turn rate does not bend it.
  std::vector<BlockMean> predicted(const std::vector<WalkRates>& rates, double late) const;

 private:
  const Drive& drive_;
  std::vector<double> cosines_, sines_;  // of the true heading in the middle of each tick
  std::vector<std::size_t> block_of_;    // of each pose; beyond the last one: none
  std::vector<std::size_t> counts_;
  std::vector<BlockMean> seen_;
};

/// A motion between the means of two blocks, in the robot's frame in the middle of them.
struct BlockStep {
  double ahead = 0, left = 0, turn = 0;  // [m, m, rad]
};

/// Returns the true motion from block `from` to block `to` less that of `predicted`.
BlockStep missed_between(const DriveTrack& track, const std::vector<BlockMean>& predicted, std::size_t from,
                         std::size_t to);
/// Returns the true motion.
BlockStep seen_between(const DriveTrack& track, std::size_t from, std::size_t to);

}  // namespace robot::fit
