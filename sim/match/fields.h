// Visits every field of a State by name. Hash, comparison and snapshot are built on it.
//
// They never use the struct's memory image: padding has no defined value, and 32- and 64-bit machines lay structs out
// differently.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

#include "sim/match/state.h"

namespace sim {

/// The path of names from the State to one of its fields.
struct FieldPath {
  struct Name {
    const char* name;
    int index;  // in an array; -1: not an array
  };
  Name names[8];
  int depth = 0;

  /// Returns the path in C++ notation: "robots[3].beliefs.ball.position.x".
  std::string text() const;
};

/// Calls see(name, member) for each member of a struct of the state, in the order of declaration. The structured
/// bindings count the members, so a new member that is missing here does not compile.
template <class Struct, class See>
void visit_members(Struct& whole, See&& see) {
  using Type = std::remove_const_t<Struct>;
  if constexpr (std::is_same_v<Type, Vec2>) {
    auto& [x, y] = whole;
    see("x", x), see("y", y);
  } else if constexpr (std::is_same_v<Type, Pose2>) {
    auto& [position, heading] = whole;
    see("position", position), see("heading", heading);
  } else if constexpr (std::is_same_v<Type, RandomKey>) {
    auto& [seed] = whole;
    see("seed", seed);
  } else if constexpr (std::is_same_v<Type, Ball>) {
    auto& [position, velocity, acceleration, past] = whole;
    see("position", position), see("velocity", velocity), see("acceleration", acceleration), see("past", past);
  } else if constexpr (std::is_same_v<Type, Official>) {
    auto& [position, velocity] = whole;
    see("position", position), see("velocity", velocity);
  } else if constexpr (std::is_same_v<Type, Body>) {
    auto& [position, heading, facing, velocity, turn_rate, head_yaw, head_pitch, look, doing, kind, kick_left,
           kick_done, kick_gain, since, step_velocity, step_turn_rate, walked, touching, pushing, glide, moved] = whole;
    see("position", position), see("heading", heading), see("facing", facing), see("velocity", velocity);
    see("turn_rate", turn_rate), see("head_yaw", head_yaw), see("head_pitch", head_pitch), see("look", look);
    see("doing", doing), see("kind", kind), see("kick_left", kick_left), see("kick_done", kick_done);
    see("kick_gain", kick_gain), see("since", since), see("step_velocity", step_velocity);
    see("step_turn_rate", step_turn_rate);
    see("walked", walked), see("touching", touching), see("pushing", pushing);
    see("glide", glide), see("moved", moved);
  } else if constexpr (std::is_same_v<Type, World>) {
    auto& [key, tick, players, home_attacks, touched, kicked, whiffed, crowded, ball, official, bodies] = whole;
    see("key", key), see("tick", tick), see("players", players), see("home_attacks", home_attacks);
    see("touched", touched), see("kicked", kicked), see("whiffed", whiffed);
    see("crowded", crowded), see("ball", ball), see("official", official), see("bodies", bodies);
  } else if constexpr (std::is_same_v<Type, referee::Book>) {
    auto& [phase, set_play, kicking, first_kick_off, last_touch, kick_off_by, last_toucher, half, ball_free,
           phase_since, playing_since, clock, told_phase_since, last_touch_tick, last_touch_at, ball_before,
           still_since, stuck_since, stuck_at, score, packets, penalties, penalised_until] = whole;
    see("phase", phase), see("set_play", set_play), see("kicking", kicking), see("first_kick_off", first_kick_off);
    see("last_touch", last_touch), see("kick_off_by", kick_off_by), see("last_toucher", last_toucher),
        see("half", half), see("ball_free", ball_free);
    see("phase_since", phase_since), see("playing_since", playing_since), see("clock", clock);
    see("told_phase_since", told_phase_since), see("last_touch_tick", last_touch_tick);
    see("last_touch_at", last_touch_at), see("ball_before", ball_before), see("still_since", still_since);
    see("stuck_since", stuck_since), see("stuck_at", stuck_at), see("score", score), see("packets", packets);
    see("penalties", penalties), see("penalised_until", penalised_until);
  } else if constexpr (std::is_same_v<Type, referee::GameCounts>) {
    auto& [kicks, whiffs, shots, possession, in_play, seen] = whole;
    see("kicks", kicks), see("whiffs", whiffs), see("shots", shots), see("possession", possession);
    see("in_play", in_play), see("seen", seen);
  } else if constexpr (std::is_same_v<Type, motion::Command>) {
    auto& [body, head, kick, kick_left, walk, turn, gain, look] = whole;
    see("body", body), see("head", head), see("kick", kick), see("kick_left", kick_left);
    see("walk", walk), see("turn", turn), see("gain", gain), see("look", look);
  } else if constexpr (std::is_same_v<Type, agent::Ball>) {
    auto& [position, velocity, variance, covariance, velocity_variance, heat, seen, visible, frames] = whole;
    see("position", position), see("velocity", velocity), see("variance", variance), see("covariance", covariance);
    see("velocity_variance", velocity_variance), see("heat", heat), see("seen", seen), see("visible", visible);
    see("frames", frames);
  } else if constexpr (std::is_same_v<Type, agent::Pose>) {
    auto& [pose, deviation, deviation_heading] = whole;
    see("pose", pose), see("deviation", deviation), see("deviation_heading", deviation_heading);
  } else if constexpr (std::is_same_v<Type, agent::Choice>) {
    auto& [strategy, epoch] = whole;
    see("strategy", strategy), see("epoch", epoch);
  } else if constexpr (std::is_same_v<Type, agent::Mate>) {
    auto& [pose, ball, sent, ball_age, time_to_ball_cs, role, active, choice] = whole;
    see("pose", pose), see("ball", ball), see("sent", sent), see("ball_age", ball_age);
    see("time_to_ball_cs", time_to_ball_cs), see("role", role), see("active", active), see("choice", choice);
  } else if constexpr (std::is_same_v<Type, agent::Opponent>) {
    auto& [position, seen] = whole;
    see("position", position), see("seen", seen);
  } else if constexpr (std::is_same_v<Type, agent::Beliefs>) {
    auto& [ball, pose, mates, opponents] = whole;
    see("ball", ball), see("pose", pose), see("mates", mates), see("opponents", opponents);
  } else if constexpr (std::is_same_v<Type, agent::Mind>) {
    auto& [role, slot, leaf, role_since, leaf_since, ball, ball_seen, search_since, kick_direction, kick, aligned,
           settled, search_side, time_to_ball_cs, holds, choice, told] = whole;
    see("role", role), see("slot", slot), see("leaf", leaf), see("role_since", role_since);
    see("leaf_since", leaf_since), see("ball", ball), see("ball_seen", ball_seen);
    see("search_since", search_since), see("kick_direction", kick_direction), see("kick", kick);
    see("aligned", aligned), see("settled", settled), see("search_side", search_side);
    see("time_to_ball_cs", time_to_ball_cs), see("holds", holds);
    see("choice", choice), see("told", told);
  } else if constexpr (std::is_same_v<Type, perception::Cognition>) {
    auto& [odometry_scale, turn_scale, last, walked, turned, flipped, on_air, packet] = whole;
    see("odometry_scale", odometry_scale), see("turn_scale", turn_scale), see("last", last), see("walked", walked);
    see("turned", turned), see("flipped", flipped), see("on_air", on_air);
    see("packet", packet);
  } else if constexpr (std::is_same_v<Type, Robot>) {
    auto& [command, beliefs, mind, cognition] = whole;
    see("command", command), see("beliefs", beliefs), see("mind", mind), see("cognition", cognition);
  } else if constexpr (std::is_same_v<Type, Schedule>) {
    auto& [next, turn, radio, lag, lost] = whole;
    see("next", next), see("turn", turn), see("radio", radio), see("lag", lag), see("lost", lost);
  } else {
    static_assert(std::is_same_v<Type, State>, "a struct of the state whose members are not listed here");
    auto& [world, schedule, book, counts, robots] = whole;
    see("world", world), see("schedule", schedule), see("book", book), see("counts", counts), see("robots", robots);
  }
}

/// Calls see(path, field) for each number, bool and enumerator in `value`, always in the same order. `path` is the path
/// to `value`.
template <class Value, class See>
void visit_fields(Value& value, FieldPath& path, See&& see) {
  if constexpr (std::is_array_v<Value>) {
    for (int i = 0; i < static_cast<int>(std::extent_v<Value>); ++i) {
      path.names[path.depth - 1].index = i;
      visit_fields(value[i], path, see);
    }
  } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
    see(static_cast<const FieldPath&>(path), value);
  } else {
    visit_members(value, [&](const char* name, auto& member) {
      path.names[path.depth++] = {name, -1};
      visit_fields(member, path, see);
      --path.depth;
    });
  }
}
template <class Value, class See>
void visit_fields(Value& value, See&& see) {
  FieldPath path;
  visit_fields(value, path, see);
}

/// Returns the last enumerator of an enumeration of the state, as a number.
template <class Enum>
constexpr unsigned last_of() {
  const auto number = [](auto enumerator) { return static_cast<unsigned>(enumerator); };
  if constexpr (std::is_same_v<Enum, Side>) return number(Side::away);
  if constexpr (std::is_same_v<Enum, Body::Doing>) return number(Body::Doing::removed);
  if constexpr (std::is_same_v<Enum, motion::Command::Body>) return number(motion::Command::Body::squat);
  if constexpr (std::is_same_v<Enum, motion::Command::Head>) return number(motion::Command::Head::look_to);
  if constexpr (std::is_same_v<Enum, agent::Game::Phase>) return number(agent::Game::Phase::finished);
  if constexpr (std::is_same_v<Enum, agent::Game::SetPlay>) return number(agent::Game::SetPlay::corner_kick);
  if constexpr (std::is_same_v<Enum, agent::Role>) return number(agent::Role::defender);
}

/// Returns the bits of a field as a number; a float has its IEEE 754 bits.
template <class Field>
constexpr std::uint64_t bits_of(Field field) {
  if constexpr (std::is_same_v<Field, float>) {
    return std::bit_cast<std::uint32_t>(field);
  } else if constexpr (std::is_enum_v<Field>) {
    return static_cast<std::underlying_type_t<Field>>(field);
  } else {
    return static_cast<std::make_unsigned_t<std::conditional_t<std::is_same_v<Field, bool>, std::uint8_t, Field>>>(
        field);
  }
}

/// Returns the field with these bits. The caller ensures that an enumeration has such an enumerator.
template <class Field>
constexpr Field field_of(std::uint64_t bits) {
  if constexpr (std::is_same_v<Field, float>) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  } else {
    return static_cast<Field>(bits);
  }
}

/// Returns the path of the first field in which two states differ, or an empty string when they are equal. Numbers are
/// compared as numbers: -0 equals 0.
std::string difference(const State& a, const State& b);

}  // namespace sim
