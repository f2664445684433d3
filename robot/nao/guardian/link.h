// Messages between guardian and runtime, each a datagram of a local socket (SOCK_SEQPACKET).
//
// Both programs come from one build and run on one machine, so a message is sent as its bytes in memory. Each message
// begins with the number of its layout. A message of another layout or length is refused.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// State of the robot in the game, set by the chest button and the referee.
enum class Mode : std::uint8_t { unstiff, initial, penalised, playing };

/// Current action of the body.
enum class Doing : std::uint8_t {
  soft,  // no joint has stiffness
  standing_up,
  standing,
  holding,  // all joints keep their positions
  sitting_down,
  falling,  // tucks in
  fallen,   // lies without stiffness
  getting_up,
};

/// Reason why the body does not obey: the first that applies.
enum class Reason : std::uint8_t {
  none,
  stopping,
  head_touched,
  asked_soft,
  fell,
  crashed,
  hot,
  battery_empty,
  sensors_missing,
  runtime_late,
  runtime_gone,
  waits_for_button,
  waits_for_game,
  not_upright,
  feet_unloaded,
  stays_down,
  warm,
  battery_low,
};

/// Returns the reason as a sentence for people, such as "there is no runtime: the robot holds still, then sits".
const char* sentence_of(Reason reason);

const char* name_of(Mode mode);
const char* name_of(Doing doing);

/// State of the GameController, as the chest shows it.
enum class GameState : std::uint8_t { none, initial, standby, ready, set, playing, finished };

/// The GameController's data about this robot.
struct GameWord {
  std::uint8_t heard = 0;  // 1: a packet arrived since the runtime started
  std::uint8_t penalised = 0;
  GameState state = GameState::none;
  std::uint8_t player = 0;  // this robot's number in it
  friend bool operator==(const GameWord&, const GameWord&) = default;
};

inline constexpr std::uint32_t kOrderLayout = 0x4f02, kReportLayout = 0x5203, kRequestLayout = 0x5101;

/// The runtime's order, sent after every report. Without new orders the body holds still, then sits, then softens.
struct Order {
  enum class Posture : std::uint8_t {
    stand,
    sit,
    freeze,
    soft,
    get_up,  // if it lies; an upright robot stands
  };

  std::uint32_t layout = kOrderLayout;
  Posture posture = Posture::stand;
  GameWord game;

  /// Joints with a 1 follow `position` while the robot stands in the mode `playing`. The others stay in the stand.
  PerJoint<std::uint8_t> drives{};
  PerJoint<float> position{};   // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};  // [0..1]
};

/// A request, which any client may send, also without an order before it.
struct Request {
  enum class What : std::uint8_t {
    sit_and_soft,  // take the stiffness away at once
    goodbye,       // this connection ends normally: no crash
  };
  std::uint32_t layout = kRequestLayout;
  What what = What::sit_and_soft;
};

/// The guardian's report, sent after every frame of LoLA, and once a second while there is no LoLA.
struct Report {
  std::uint32_t layout = kReportLayout;
  Mode mode = Mode::unstiff;
  Doing doing = Doing::soft;
  Reason reason = Reason::none;
  bool has_lola = false;         // LoLA is connected: the guardian holds the joints
  bool has_sensors = false;      // `sensors` are those of this frame; false: `problem` says why not
  bool lola_is_taken = false;    // another program has it
  bool limited = false;          // a warm joint or a low battery: half the speed
  bool lies_known = false;       // `lies_*` are valid
  float lies_roll = 0;           // [rad] of the torso when it fell
  float lies_pitch = 0;          // [rad]
  float remaining = 0;           // [s] until the current motion ends
  std::uint64_t capture_ns = 0;  // [ns, monotonic clock] arrival of the frame
  std::uint64_t frames = 0;      // answered since the guardian started
  Sensors sensors;
  PerJoint<float> commanded{};            // [rad] in the answer to this frame
  PerJoint<float> commanded_stiffness{};  // [0..1]
  std::array<char, 24> body_id{}, body_version{}, head_id{}, head_version{};
  std::array<char, 200> problem{};  // one sentence
};

static_assert(std::is_trivially_copyable_v<Order> && std::is_trivially_copyable_v<Report> &&
              std::is_trivially_copyable_v<Request>);

}  // namespace robot::nao
