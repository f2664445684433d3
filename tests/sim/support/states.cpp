#include "tests/sim/support/states.h"

#include <algorithm>
#include <set>
#include <string>

#include "sim/match/fields.h"

namespace sim::test {

State scrambled(std::uint64_t seed) {
  State state{};
  std::uint32_t number = 0;
  visit_fields(state, [&](const FieldPath&, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    const std::uint32_t word = draw({seed}, kNobody, Event::situation, number++)[0];
    if constexpr (std::is_same_v<Field, float>)
      field = 200 * uniform(word) - 100;
    else if constexpr (std::is_same_v<Field, bool>)
      field = word % 2 == 1;
    else if constexpr (std::is_enum_v<Field>)
      field = static_cast<Field>(word % (last_of<Field>() + 1));
    else
      field = static_cast<Field>(word);
  });

  // what counts or points into an array
  World& world = state.world;
  world.players = 1 + (world.players & 3);
  world.home_attacks = world.home_attacks > 0 ? 1.f : -1.f;
  world.touched = world.kicked = world.whiffed = state.book.last_toucher = kNobody;
  for (int i = 0; i < kMaxRobots; ++i)
    world.bodies[i].kick = state.robots[i].command.kick = state.robots[i].mind.kick = 0;
  return state;
}

namespace {

/// Angles and the like, which a mirror turns round; a factor of noise along y is none of them.
const std::set<std::string> kTurned{"heading", "turn_rate", "head_yaw",    "turn_noise",
                                    "turned",  "turn",      "search_side", "kick_direction"};
const std::set<std::string> kFactors{"noise", "odometry_scale"};

void mirror_command(motion::Command& command) {
  if (command.head == motion::Command::Head::angles) command.look[0] = -command.look[0];
  if (command.head == motion::Command::Head::look_to) command.look[1] = -command.look[1];
  command.kick_left = !command.kick_left;
}

}  // namespace

State mirrored(const State& state) {
  State image = state;
  visit_fields(image, [](const FieldPath& path, auto& field) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(field)>, float>) {
      const std::string name = path.names[path.depth - 1].name;
      const bool along_y = name == "y" && !kFactors.contains(path.names[path.depth - 2].name);
      // π is its own image: angles are in (-π, π]
      if ((along_y || kTurned.contains(name)) && field != kPi) field = -field;
    }
  });
  for (int i = 0; i < kMaxRobots; ++i) {
    image.world.bodies[i].kick_left = !image.world.bodies[i].kick_left;
    mirror_command(image.robots[i].command);
  }
  return image;
}

State exchanged(const State& state) {
  State other_names = state;
  World& world = other_names.world;
  world.home_attacks = -world.home_attacks;
  std::swap_ranges(world.bodies, world.bodies + kMaxPlayers, world.bodies + kMaxPlayers);
  std::swap_ranges(other_names.robots, other_names.robots + kMaxPlayers, other_names.robots + kMaxPlayers);
  referee::Book& book = other_names.book;
  for (std::uint8_t* robot : {&world.touched, &world.kicked, &world.whiffed, &book.last_toucher})
    if (*robot != kNobody) *robot = static_cast<std::uint8_t>((*robot + kMaxPlayers) % kMaxRobots);

  for (Side* side : {&book.kicking, &book.first_kick_off, &book.last_touch}) *side = other(*side);
  std::swap(book.score[0], book.score[1]);
  std::swap(book.packets[0], book.packets[1]);
  std::swap(book.penalties[0], book.penalties[1]);
  std::swap_ranges(book.penalised_until, book.penalised_until + kMaxPlayers, book.penalised_until + kMaxPlayers);

  referee::Tally& tally = other_names.tally;
  for (auto* pair : {&tally.kicks, &tally.whiffs, &tally.shots}) std::swap((*pair)[0], (*pair)[1]);
  std::swap(tally.possession[0], tally.possession[1]);
  std::swap_ranges(tally.seen, tally.seen + kMaxPlayers, tally.seen + kMaxPlayers);
  return other_names;
}

Params exchanged(const Params& params) {
  Params other_names = params;
  std::swap(other_names.teams[0], other_names.teams[1]);
  return other_names;
}

State without_leftovers(State state) {
  for (int i = 0; i < kMaxRobots; ++i) {
    Body& body = state.world.bodies[i];
    if (body.doing != Body::Doing::kicking) body.kick_left = false;
    motion::Command& command = state.robots[i].command;
    if (command.body != motion::Command::Body::kick) command.kick_left = false;
  }
  return state;
}

}  // namespace sim::test
