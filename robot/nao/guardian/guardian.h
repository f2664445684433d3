// The rules that decide in every cycle of 12 ms which values reach the joints. Pure: no clock, no files, no sockets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/nao/guardian/key_frames.h"
#include "robot/nao/guardian/limiter.h"
#include "robot/nao/guardian/link.h"
#include "robot/nao/guardian/touches.h"
#include "robot/nao/guardian/watch.h"
#include "robot/nao/lola/actuators.h"
#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// The inputs of one cycle.
struct Cycle {
  std::uint64_t now_ns = 0;          // [ns, monotonic clock]
  const Sensors* sensors = nullptr;  // null: the frame could not be read
  const Order* order = nullptr;      // the newest since the last cycle; null: none came
  bool asked_soft = false;           // a client asked to sit and soften
  bool runtime_left = false;         // its connection ended after a goodbye
  bool runtime_crashed = false;      // it ended without a goodbye
  bool stop = false;                 // end the guardian as soon as the robot sits
};

/// The guardian of the joints. In each cycle it follows the first of these rules that applies:
///
///   the three head sensors held, or sit_and_soft   no joint has stiffness from that cycle on, until the chest button
///   it falls                                       tucks in, then is soft; when it is upright again it may stand up.
///                                                  If ordered, it gets up once it lies still, in up to three attempts
///   asked to end; a joint too hot; battery empty   sits down, then is soft
///   the third crash of the runtime in a minute     the same, with red eyes, until the chest button
///   no order, or no readable frame                 for 0.1 s: holds still; for 3 s: sits down, then is soft. A robot
///                                                  whose legs were driven stands first
///   the runtime or the guardian has restarted      holds still, until GameController or chest button allow more
///   mode initial, penalised                        stands; no order moves it
///   mode playing                                   as the order says
///
/// The chest button leads from unstiff to initial, penalised and playing, and then switches between penalised and
/// playing. A state of the GameController counts from the moment it changes. It never ends the mode unstiff. The button
/// does not end that mode either while there is no runtime. The robot stands up only with its torso upright. Before it
/// stretches its legs it also needs weight on its feet. A robot that has stiffness at the guardian's first cycle holds
/// still.
class Guardian {
 public:
  static constexpr std::uint64_t kHoldAfter_ns = 100'000'000;
  static constexpr std::uint64_t kSitAfter_ns = 3'000'000'000;
  static constexpr std::uint64_t kTuckFor_ns = 1'000'000'000;  // from the beginning of a fall
  static constexpr std::uint64_t kCrashWindow_ns = 60'000'000'000;
  static constexpr std::size_t kCrashes = 3;
  static constexpr std::uint64_t kSinksFor_ns = 1'000'000'000;           // from its last stiffness until it rests
  static constexpr std::uint64_t kLiesFor_ns = 500'000'000;              // before an attempt to get up
  static constexpr int kAttempts = 3;                                    // to get up after a fall
  static constexpr std::array<float, kAttempts> kLonger{1, 1.2f, 1.4f};  // durations of the attempts
  static constexpr float kLongestStep = 0.012f;  // [s] longest motion of the joints in one cycle, also when it is late

  explicit Guardian(WatchBounds bounds = {}) : watch_(bounds) {}

  /// Returns the answer to this cycle. Times must never decrease.
  const Actuators& step(const Cycle& cycle);

  /// Forgets the state of the body, because LoLA was gone for a while. The next cycle determines it again. Then no
  /// order moves the body until the GameController or the chest button allows it.
  void lose_lola();

  Mode mode() const { return mode_; }
  Doing doing() const { return doing_; }
  Reason reason() const { return reason_; }
  bool limited() const { return limited_; }
  bool soft() const { return doing_ == Doing::soft || doing_ == Doing::fallen; }

  /// Returns roll and pitch of the torso when it fell [rad], or nothing while the robot does not fall or lie.
  std::optional<std::array<float, 2>> fell() const;

  /// Returns the number of attempts to get up that failed since it was last upright.
  int failed_attempts() const { return attempts_; }

  /// Returns the time until the current motion ends [s].
  float remaining() const;

 private:
  enum class Wish { soft, sit, hold, stand, get_up };

  void begin(const Cycle& cycle);
  void take_order(const Cycle& cycle);
  void count_crash(std::uint64_t now_ns);
  void take_click(std::uint64_t now_ns);
  void heed_falls(std::uint64_t now_ns);
  bool on_ground() const { return doing_ == Doing::fallen || doing_ == Doing::getting_up; }
  bool moves() const;
  void start_getting_up();
  void end_getting_up();
  void end_attempt();
  bool lies_still() const;
  void lie();
  Wish wish(const Cycle& cycle);
  Wish wish_on_ground(Wish wish);
  Wish wish_upright(const Cycle& cycle);
  Wish wish_without_order(std::uint64_t silent_ns, Reason why);
  void follow(Wish wish);
  bool ends_walk();
  void rise();
  void move(float dt);
  Pose standing_pose() const;
  bool in_stand() const;
  void start(Doing doing, KeyFrames motion, float longer = 1);
  void light(std::uint64_t now_ns);

  Watch watch_;
  Touches touches_;
  Limiter limiter_;
  Player player_;
  Sensors sensors_;
  Order order_;
  Actuators actuators_;

  Mode mode_ = Mode::unstiff;
  Doing doing_ = Doing::soft;
  Reason reason_ = Reason::none;
  Reason soft_because_ = Reason::waits_for_button;  // while the mode is unstiff
  bool limited_ = false;
  bool crashed_ = false;
  bool softened_ = false;  // by people, until they press the chest button
  bool waits_for_game_ = false;
  bool has_runtime_ = false;
  bool begun_ = false;        // false: the state of the body is unknown
  bool holds_stand_ = false;  // the held pose is the stand
  bool ends_walk_ = false;    // the motion is the one of ends_walk()
  bool feet_missed_ = false;  // it sat down again because there was no weight on its feet
  bool rolls_over_ = false;   // the motion that gets it up ends on the back
  bool rolled_ = false;       // that motion has ended, but the robot does not lie still yet
  int attempts_ = 0;          // to get up that failed since it was last upright

  std::uint64_t last_ns_ = 0, last_order_ns_ = 0, last_sensors_ns_ = 0, falls_since_ns_ = 0, lies_since_ns_ = 0;
  std::array<std::uint64_t, kCrashes> crash_ns_{};  // the last crashes, the newest first; 0: none
  std::optional<GameWord> game_;                    // the last word of this runtime
  std::array<float, 2> fell_{};
};

}  // namespace robot::nao
