// The decisions of a robot as a log of Groot2, the viewer of BehaviorTree.CPP.
//
// The format is BehaviorTree.CPP's FileLogger2, protocol 1 (src/loggers/bt_file_logger_v2.cpp of its version 4). All
// numbers are little endian:
//
//   18 bytes  "BTCPP4-FileLogger2"
//   1 byte    the protocol: 1
//   4 bytes   the size of the XML, then the XML of the tree. Each element has its number, _uid
//   8 bytes   the begin [us since the epoch]
//   then for each change: 6 bytes time since the begin [us], 2 bytes _uid, 1 byte status
//
// A comparison becomes the control IfThenElse with a condition, and a leaf an action. A part that several comparisons
// share is written for each of them, because an XML element has one parent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/debug/evaluation.h"
#include "sim/math/tick.h"

namespace sim::report {

/// A log that is being written. The begin is 0, and times are those since the first tick of the game.
class BtLog {
 public:
  static constexpr std::size_t kMostElements = 0xffff;  // a number has two bytes

  /// Begins with the tree. Returns an Error if it has too many elements when shared parts are written several times.
  static robot::Result<BtLog> of(const agent::Tree& tree);

  /// Appends the changes since the last decision. Times must not decrease.
  void decided(Tick tick, const debug::Evaluation& evaluation);
  /// Appends that the robot does not play: all elements become idle.
  void rests(Tick tick) { become(tick, {}); }

  const std::string& bytes() const { return bytes_; }

 private:
  enum class Status : std::uint8_t { idle, running, success, failure };
  struct State {
    std::uint16_t uid;
    Status status;
    friend bool operator==(const State&, const State&) = default;
  };
  struct Element {
    std::uint16_t uid;            // of the control, its condition has the next one; or of the action
    std::uint16_t node;           // or leaf (kLeafBit)
    std::size_t yes = 0, no = 0;  // elements
  };

  explicit BtLog(const agent::Tree& tree);

  std::size_t write(const agent::Tree& tree, std::uint16_t at, int depth, std::string& xml);
  void become(Tick tick, std::vector<State> states);
  void append(Tick tick, const State& state);

  std::vector<Element> elements_;
  std::size_t root_ = 0;
  std::uint16_t uids_ = 0;
  std::vector<State> now_;  // all elements that are not idle, from the root
  std::string bytes_;
};

}  // namespace sim::report
