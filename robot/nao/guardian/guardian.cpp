#include "robot/nao/guardian/guardian.h"

#include <algorithm>
#include <cmath>

#include "robot/nao/guardian/get_up.h"
#include "robot/nao/guardian/lights.h"

namespace robot::nao {
namespace {

constexpr float kHasStiffness = 0.1f;  // [0..1] mean of the joints in the first cycle
constexpr float kInStand = 0.03f;      // [rad] largest error of a joint in the stand

bool is_driven(const Order& order, std::size_t joint) {
  return order.drives[joint] == 1 && std::isfinite(order.position[joint]) && std::isfinite(order.stiffness[joint]);
}

bool drives_legs(const Order& order) {
  for (std::size_t joint = l_hip_yaw_pitch; joint <= r_ankle_roll; ++joint)
    if (is_driven(order, joint)) return true;
  return false;
}

}  // namespace

std::optional<std::array<float, 2>> Guardian::fell() const {
  if (doing_ != Doing::falling && !on_ground()) return std::nullopt;
  return fell_;
}

bool Guardian::moves() const {
  return doing_ == Doing::standing_up || doing_ == Doing::sitting_down || doing_ == Doing::falling ||
         doing_ == Doing::getting_up;
}

float Guardian::remaining() const { return moves() ? player_.remaining() : 0; }

const Actuators& Guardian::step(const Cycle& cycle) {
  if (cycle.sensors) {
    sensors_ = *cycle.sensors;
    last_sensors_ns_ = cycle.now_ns;
    touches_.see(sensors_, cycle.now_ns);
    watch_.see(sensors_, cycle.now_ns);
  }
  if (!begun_) begin(cycle);
  const float dt = std::min(static_cast<float>(cycle.now_ns - last_ns_) * 1e-9f, kLongestStep);
  last_ns_ = cycle.now_ns;
  if (cycle.runtime_crashed) count_crash(cycle.now_ns);
  if (cycle.runtime_crashed || cycle.runtime_left) {
    has_runtime_ = false;
    game_.reset();
    waits_for_game_ = mode_ != Mode::unstiff;
  }
  take_order(cycle);
  if (cycle.sensors && touches_.clicked()) take_click(cycle.now_ns);

  if (touches_.head_held() || cycle.asked_soft) {
    mode_ = Mode::unstiff;
    softened_ = true;
    soft_because_ = touches_.head_held() ? Reason::head_touched : Reason::asked_soft;
    doing_ = Doing::soft;
  }
  heed_falls(cycle.now_ns);
  limited_ = watch_.warm() || watch_.battery_low();
  if (const Wish wished = wish(cycle); doing_ != Doing::falling) follow(wished);
  move(dt);
  light(cycle.now_ns);
  return actuators_;
}

/// Takes over the pose of the first frame. A stiff and upright robot was under control, so it keeps its stiffness and
/// holds still until its task is known.
void Guardian::begin(const Cycle& cycle) {
  if (!cycle.sensors) return;
  begun_ = true;
  last_ns_ = last_order_ns_ = cycle.now_ns;
  Pose found{.position = sensors_.position, .stiffness = sensors_.stiffness};
  float mean = 0;
  for (const float stiffness : sensors_.stiffness) mean += clamp(stiffness, {0, 1}) / kJoints;
  if (mean < kHasStiffness || !watch_.upright() || softened_) found.stiffness.fill(0);
  limiter_.start(found);
  if (found.stiffness == PerJoint<float>{}) return;
  if (mode_ == Mode::unstiff) mode_ = Mode::initial;
  doing_ = Doing::holding;
  holds_stand_ = false;
  waits_for_game_ = true;
}

void Guardian::lose_lola() {
  begun_ = false;
  doing_ = Doing::soft;
  game_.reset();
  waits_for_game_ = mode_ != Mode::unstiff;
}

void Guardian::take_order(const Cycle& cycle) {
  if (!cycle.order) return;
  order_ = *cycle.order;
  last_order_ns_ = cycle.now_ns;
  has_runtime_ = true;
  const GameWord& word = order_.game;
  if (!word.heard || word == game_) return;
  const bool says_another = !game_ || word.penalised != game_->penalised || word.state != game_->state;
  game_ = word;
  if (!says_another || mode_ == Mode::unstiff) return;
  waits_for_game_ = false;
  if (word.penalised) {
    mode_ = Mode::penalised;
  } else {
    const bool before = word.state == GameState::initial || word.state == GameState::standby;
    mode_ = before ? Mode::initial : Mode::playing;
  }
}

void Guardian::count_crash(std::uint64_t now_ns) {
  std::copy_backward(crash_ns_.begin(), crash_ns_.end() - 1, crash_ns_.end());
  crash_ns_.front() = now_ns;
  if (crash_ns_.back() != 0 && now_ns - crash_ns_.back() < kCrashWindow_ns) crashed_ = true;
}

void Guardian::take_click(std::uint64_t now_ns) {
  waits_for_game_ = false;
  feet_missed_ = false;
  if (crashed_) {
    // the first click acknowledges the crashes; the next one makes the robot stand up
    crashed_ = false;
    crash_ns_ = {};
    mode_ = Mode::unstiff;
    soft_because_ = Reason::waits_for_button;
    return;
  }
  switch (mode_) {
    case Mode::unstiff:
      // there is no runtime, and the robot must not begin to move when one connects
      if (!has_runtime_ || now_ns - last_order_ns_ >= kHoldAfter_ns) return;
      mode_ = Mode::initial;
      softened_ = false;
      game_.reset();  // the current state of the GameController applies
      break;
    case Mode::initial:
    case Mode::playing: mode_ = Mode::penalised; break;
    case Mode::penalised: mode_ = Mode::playing; break;
  }
  soft_because_ = Reason::waits_for_button;
}

void Guardian::heed_falls(std::uint64_t now_ns) {
  if (doing_ == Doing::fallen) {
    // a roll ends where the weight of the robot brings it to rest
    if (rolled_ && lies_still()) {
      rolled_ = false;
      if (lying(sensors_.angles) != Lying::on_back) ++attempts_;
    }
    // a robot that broke off its getting up may be upright still, but its soft joints give way
    if (!watch_.upright_lasts() || now_ns - lies_since_ns_ < kSinksFor_ns) return;
    doing_ = Doing::soft;
    attempts_ = 0;
    return;
  }
  if (doing_ == Doing::getting_up) {
    const Range viable = player_.frame().pitch;
    if (sensors_.angles[1] < viable.low || sensors_.angles[1] > viable.high) end_attempt();
    return;
  }
  if (doing_ == Doing::standing && watch_.upright_lasts()) attempts_ = 0;
  if (doing_ == Doing::falling) {
    if (now_ns - falls_since_ns_ >= kTuckFor_ns) lie();
    return;
  }
  if (soft() || !watch_.falls()) return;
  fell_ = sensors_.angles;
  falls_since_ns_ = now_ns;
  start(Doing::falling, tuck());
}

Guardian::Wish Guardian::wish_without_order(std::uint64_t silent_ns, Reason why) {
  reason_ = why;
  return silent_ns >= kSitAfter_ns ? Wish::sit : Wish::hold;
}

void Guardian::start_getting_up() {
  const Lying side = lying(sensors_.angles);
  rolls_over_ = side != Lying::on_back;
  // the same motion would fail in the same way
  start(Doing::getting_up, get_up(side), rolls_over_ ? 1 : kLonger[static_cast<std::size_t>(attempts_)]);
}

/// Ends the motion. A robot that has rolled over gets up next, once it lies still.
void Guardian::end_getting_up() {
  if (rolls_over_) {
    lie();
    rolled_ = true;
  } else if (!watch_.upright()) {
    end_attempt();
  } else {
    doing_ = Doing::standing;
  }
}

/// Ends an attempt to get up that went wrong. The robot lies down softly.
void Guardian::end_attempt() {
  lie();
  ++attempts_;
}

void Guardian::lie() {
  doing_ = Doing::fallen;
  lies_since_ns_ = last_ns_;
  rolled_ = false;
}

/// Reports whether the robot lies still, long enough to get up.
bool Guardian::lies_still() const { return watch_.still() && last_ns_ - lies_since_ns_ >= kLiesFor_ns; }

/// Returns the action that the rules ask for, and sets the reason if it differs from the order.
Guardian::Wish Guardian::wish(const Cycle& cycle) {
  if (doing_ == Doing::falling) {
    reason_ = Reason::fell;
    return Wish::soft;
  }
  const Wish wished = wish_upright(cycle);
  return on_ground() ? wish_on_ground(wished) : wished;
}

/// Returns the action of a robot that would do `wish` if it were upright: it lies soft, or gets up.
Guardian::Wish Guardian::wish_on_ground(Wish wish) {
  if (doing_ == Doing::getting_up) return wish == Wish::get_up ? wish : Wish::soft;
  const bool tired = attempts_ >= kAttempts;
  reason_ = tired ? Reason::stays_down : Reason::fell;
  const bool ready = !watch_.upright() && lies_still();
  return wish == Wish::get_up && !tired && ready ? wish : Wish::soft;
}

/// Returns the action that the rules ask for, without those about falls.
Guardian::Wish Guardian::wish_upright(const Cycle& cycle) {
  const auto because = [&](Reason reason, Wish wish) {
    reason_ = reason;
    return wish;
  };
  const std::uint64_t silent_ns = cycle.now_ns - last_order_ns_, blind_ns = cycle.now_ns - last_sensors_ns_;
  if (cycle.stop) return because(Reason::stopping, Wish::sit);
  if (crashed_) return because(Reason::crashed, Wish::sit);
  if (mode_ == Mode::unstiff) return because(soft_because_, Wish::sit);
  if (watch_.hot()) return because(Reason::hot, Wish::sit);
  if (watch_.battery_empty()) return because(Reason::battery_empty, Wish::sit);
  if (blind_ns >= kHoldAfter_ns) return wish_without_order(blind_ns, Reason::sensors_missing);
  if (silent_ns >= kHoldAfter_ns || !has_runtime_)
    return wish_without_order(silent_ns, has_runtime_ ? Reason::runtime_late : Reason::runtime_gone);
  if (waits_for_game_) return because(Reason::waits_for_game, Wish::hold);

  reason_ = watch_.warm() ? Reason::warm : watch_.battery_low() ? Reason::battery_low : Reason::none;
  if (mode_ != Mode::playing) return Wish::stand;
  switch (order_.posture) {
    case Order::Posture::stand: return Wish::stand;
    case Order::Posture::sit: return Wish::sit;
    case Order::Posture::soft: return Wish::soft;
    case Order::Posture::freeze: return Wish::hold;
    case Order::Posture::get_up: return Wish::get_up;
  }
  return Wish::hold;  // an unknown posture
}

void Guardian::follow(Wish wish) {
  if (on_ground()) {
    if (wish == Wish::get_up && doing_ == Doing::fallen) start_getting_up();
    if (wish != Wish::get_up && doing_ == Doing::getting_up) lie();
    return;
  }
  if (wish == Wish::soft) {
    doing_ = Doing::soft;
    return;
  }
  if (wish == Wish::get_up) wish = Wish::stand;
  if (wish != Wish::stand) feet_missed_ = false;
  // sitting down is never interrupted
  if (soft() ? wish != Wish::stand : doing_ == Doing::sitting_down) return;
  switch (wish) {
    case Wish::sit: return start(Doing::sitting_down, sit());
    case Wish::hold:
      if (ends_walk()) return;
      if (doing_ != Doing::holding) holds_stand_ = doing_ == Doing::standing;
      doing_ = Doing::holding;
      return;
    case Wish::stand: return rise();
    case Wish::soft:
    case Wish::get_up: return;
  }
}

/// Lets a robot stand that walked when it must hold still: a foot may be in the air. Returns false when that is done.
bool Guardian::ends_walk() {
  if (doing_ == Doing::standing_up && ends_walk_) return true;
  if (doing_ != Doing::standing || mode_ != Mode::playing || !drives_legs(order_)) return false;
  order_.drives = {};  // they are not followed any more
  start(Doing::standing_up, stand());
  ends_walk_ = true;
  return true;
}

/// Starts or continues to stand up, or sets the reason why not.
void Guardian::rise() {
  if (doing_ == Doing::standing_up) {
    if (!player_.needs_feet() || watch_.on_feet()) return;
    feet_missed_ = true;
    reason_ = Reason::feet_unloaded;
    return start(Doing::sitting_down, sit());
  }
  const bool calm = mode_ != Mode::playing;
  if (doing_ == Doing::standing && (!calm || in_stand())) return;
  if (!watch_.upright()) {
    reason_ = Reason::not_upright;
    return;
  }
  // a person held the robot up and its feet had no weight: they must put it down first
  if (soft() && feet_missed_ && !watch_.on_feet()) {
    reason_ = Reason::feet_unloaded;
    return;
  }
  feet_missed_ = false;
  // it only held still in the stand: no motion is needed
  if (doing_ == Doing::holding && holds_stand_ && !calm) {
    doing_ = Doing::standing;
    return;
  }
  start(Doing::standing_up, soft() ? stand_up() : stand());
}

void Guardian::start(Doing doing, KeyFrames motion, float longer) {
  doing_ = doing;
  ends_walk_ = false;
  if (limiter_.pose().stiffness == PerJoint<float>{}) limiter_.soften(sensors_.position);
  player_.play(motion, limiter_.pose().position, longer);
}

bool Guardian::in_stand() const {
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (std::abs(limiter_.pose().position[joint] - stand_pose().position[joint]) > kInStand) return false;
  return true;
}

/// Returns the stand, with the joints that the order drives.
Pose Guardian::standing_pose() const {
  Pose pose{.position = stand_pose().position, .stiffness = {}};
  pose.stiffness.fill(stand_pose().stiffness);
  if (mode_ != Mode::playing) return pose;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    if (!is_driven(order_, joint)) continue;
    pose.position[joint] = order_.position[joint];
    pose.stiffness[joint] = order_.stiffness[joint];
  }
  return pose;
}

void Guardian::move(float dt) {
  const bool plays = moves();
  if (plays) limiter_.next(player_.next(dt), sensors_.position, dt, 1);
  if (doing_ == Doing::standing) limiter_.next(standing_pose(), sensors_.position, dt, limited_ ? 0.5f : 1);
  if (plays && player_.finished()) {
    if (doing_ == Doing::getting_up) end_getting_up();
    if (doing_ == Doing::standing_up) doing_ = Doing::standing;
    if (doing_ == Doing::sitting_down) doing_ = Doing::soft;
  }
  if (soft()) limiter_.soften(sensors_.position);
  actuators_.position = limiter_.pose().position;
  actuators_.stiffness = limiter_.pose().stiffness;
}

void Guardian::light(std::uint64_t now_ns) {
  actuators_.lights = lights_of({.mode = mode_,
                                 .game = game_ ? game_->state : GameState::none,
                                 .crashed = crashed_,
                                 .troubled = reason_ != Reason::none && reason_ != Reason::waits_for_button,
                                 .charge = sensors_.battery[0],
                                 .now_ns = now_ns});
}

}  // namespace robot::nao
