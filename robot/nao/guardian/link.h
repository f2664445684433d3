// What the guardian and the runtime say to each other, each message a datagram of a local socket (SOCK_SEQPACKET).
//
// Both are programs of one build on one machine, so messages travel as they lie in memory; each begins with the number of
// its layout, and one of another layout or length is refused.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// What people and referee say the robot is.
enum class Mode : std::uint8_t { unstiff, initial, penalised, playing };

/// What the body does.
enum class Doing : std::uint8_t {
  soft,  // no joint has stiffness
  standing_up,
  standing,
  holding,  // all joints stay where they are
  sitting_down,
  falling,  // tucks in
  fallen,   // soft, and lies
};

/// Why the body does not do what it is asked to; the first that holds.
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
  warm,
  battery_low,
};

/// The same in words, for people: "a joint is too hot: it sits until that has cooled".
const char* sentence_of(Reason reason);

const char* name_of(Mode mode);
const char* name_of(Doing doing);

/// How the GameController's state shows on the chest.
enum class GameState : std::uint8_t { none, initial, standby, ready, set, playing, finished };

/// What the GameController said of this robot.
struct GameWord {
  std::uint8_t heard = 0;  // 1: a packet came since the runtime started
  std::uint8_t penalised = 0;
  GameState state = GameState::none;
  std::uint8_t player = 0;  // our number in it
  friend bool operator==(const GameWord&, const GameWord&) = default;
};

inline constexpr std::uint32_t kOrderLayout = 0x4f01, kReportLayout = 0x5201, kRequestLayout = 0x5101;

/// What the runtime wants, with every report it gets. When it stops saying so, the body holds still, then sits, then
/// softens.
struct Order {
  enum class Posture : std::uint8_t { stand, sit, freeze, soft };

  std::uint32_t layout = kOrderLayout;
  Posture posture = Posture::stand;
  GameWord game;

  /// Joints with a 1 go where `position` says while the robot stands in the mode `playing`; others stay in the stand.
  PerJoint<std::uint8_t> drives{};
  PerJoint<float> position{};   // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};  // [0..1]
};

/// What anybody may ask for; no order needs to have come before.
struct Request {
  enum class What : std::uint8_t {
    sit_and_soft,  // take the stiffness away at once
    goodbye,       // this connection ends on purpose: no crash
  };
  std::uint32_t layout = kRequestLayout;
  What what = What::sit_and_soft;
};

/// What the guardian tells: with every frame of LoLA's, and once a second while there is none.
struct Report {
  std::uint32_t layout = kReportLayout;
  Mode mode = Mode::unstiff;
  Doing doing = Doing::soft;
  Reason reason = Reason::none;
  bool has_sensors = false;      // false: there is no LoLA, `problem` says why
  bool lola_is_taken = false;    // somebody else has it
  bool limited = false;          // a warm joint or a low battery: half the speed
  bool lies_known = false;       // `lies_*` mean something
  float lies_roll = 0;           // [rad] of the torso when it fell
  float lies_pitch = 0;          // [rad]
  float remaining = 0;           // [s] of the motion that is under way
  std::uint64_t capture_ns = 0;  // [ns, monotonic clock] when the frame came
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
