#include "sim/environment/actions.h"

#include <cmath>

#include "sim/agent/manners.h"
#include "sim/io/json.h"

namespace sim::environment {

using agent::clamp;

namespace {

bool is_number_below(float value, int count) {
  return value >= 0 && value < static_cast<float>(count) && value == std::floor(value);
}

std::string expected_number(int count, float got) {
  return "must be a whole number 0 .. " + std::to_string(count - 1) + ", got " + io::short_text(got);
}

std::string problem_of_arguments(const agent::SkillInfo& skill, const float* arguments) {
  for (int i = 0; i < skill.count; ++i) {
    const agent::ParameterInfo& info = skill.parameters[i];
    const float value = arguments[i], least = info.range.least, most = info.range.most;
    if (std::isnan(value)) continue;
    const bool is_whole = !info.range.names || value == std::floor(value);
    if (!(value >= least && value <= most && is_whole))
      return std::string("has ") + info.name + " of " + skill.name + ", which must be " + io::short_text(least) +
             " .. " + io::short_text(most) + (info.range.names ? ", a whole number" : "") + ", got " +
             io::short_text(value);
  }
  return {};
}

/// Returns the index of the kick, or -1 for none.
int kick_of(float value, int kicks) {
  const float strength = 2 * std::abs(value) - 1;
  if (!(strength > 0) || kicks == 0) return -1;
  const int kick = static_cast<int>(strength * static_cast<float>(kicks));
  return kick < kicks ? kick : kicks - 1;
}

motion::Command run_skill(const float* row, const agent::View& view, agent::Mind& mind) {
  const agent::SkillInfo& skill = agent::info_of(static_cast<agent::Skill>(row[0]));
  float arguments[agent::kMaxArguments];
  for (int i = 0; i < skill.count; ++i)
    arguments[i] = std::isnan(row[1 + i]) ? skill.parameters[i].standard : row[1 + i];
  if (!skill.searches) mind.search_since = kNever;
  motion::Command command = skill.run(arguments, view, mind);
  agent::mind_manners(view, command);
  return command;
}

}  // namespace

std::string problem_of(Kind kind, const agent::Tree& tree, const float* row) {
  if (kind == Kind::menu) {
    const int rules = static_cast<int>(tree.menu.size());
    return is_number_below(row[0], rules) ? std::string() : expected_number(rules, row[0]);
  }
  if (kind == Kind::skills) {
    const int skills = agent::skill_count();
    if (!is_number_below(row[0], skills)) return expected_number(skills, row[0]);
    return problem_of_arguments(agent::info_of(static_cast<agent::Skill>(row[0])), row + 1);
  }
  for (int i = 0; i < kMotionWidth; ++i)
    if (std::isnan(row[i])) return std::string("has ") + kMotionNames[i] + ", which must be a number, got NaN";
  return {};
}

motion::Command obey(Kind kind, const agent::Tree& tree, const float* row, const agent::View& view, agent::Mind& mind) {
  if (kind == Kind::menu) return agent::play_choice(tree, static_cast<int>(row[0]), view, mind, nullptr);
  // like a leaf, so that the next decision knows that the robot plays
  mind.leaf = 0;
  if (kind == Kind::skills) return run_skill(row, view, mind);
  mind.search_since = kNever;
  return command_of(row, *view.around.motion);
}

motion::Command command_of(const float* row, const motion::Model& model) {
  const auto share = [&](int i) { return clamp(row[i], -1, 1); };
  const motion::Walk& walk = model.walk;
  motion::Command command;
  command.head = motion::Command::Head::angles;
  command.look[0] = share(5) * model.head.yaw_limit;
  command.look[1] = share(6) > 0 ? share(6) * model.head.pitch_down : -share(6) * model.head.pitch_up;
  if (const int kick = kick_of(share(3), model.kick_count); kick >= 0) {
    command.body = motion::Command::Body::kick;
    command.kick = static_cast<std::uint8_t>(kick);
    command.kick_left = row[3] > 0;
  } else if (share(4) > 0.5f) {
    command.body = motion::Command::Body::squat;
  } else {
    command.body = motion::Command::Body::walk_speed;
    command.walk = {share(0) * (share(0) > 0 ? walk.forward : walk.backward), share(1) * walk.sideward};
    command.turn = share(2) * walk.turn_rate;
  }
  return command;
}

}  // namespace sim::environment
