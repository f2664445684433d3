#include "sim/agent/skills.h"

#include <iterator>

#include "sim/agent/ball_skills.h"
#include "sim/agent/go_to.h"
#include "sim/agent/head.h"
#include "sim/agent/own.h"
#include "sim/agent/place_skills.h"
#include "sim/agent/search.h"

namespace sim::agent {
namespace {

template <motion::Command (*Function)(const View&)>
motion::Command plain(const View& view, Mind&, const NoArguments&) {
  return Function(view);
}

constexpr SkillInfo searching(SkillInfo row) {
  row.searches = true;
  return row;
}

// the table of skills; the parameters of each are listed at its struct
constexpr SkillInfo kTable[] = {
    skill<NoArguments, plain<stand>>("stand", "stands, with the head on the ball or searching"),
    searching(skill<SearchBall, search_ball>("search_ball", "scans, turns, then walks about")),
    skill<LookRound, look_round>("look_round", "stands and looks for marks"),
    skill<WalkToBall, walk_to_ball>("walk_to_ball", "goes behind the ball, round it when necessary"),
    skill<Align, align>("align", "stands so that a kick would send the ball to the aim"),
    skill<Kick, kick>("kick", "aligns, and kicks as soon as the ball lies right"),
    skill<Dribble, dribble>("dribble", "walks the ball towards the aim"),
    skill<Pass, pass>("pass", "kicks to the free teammate, or straight ahead when there is none"),
    skill<GoTo, go_to>("go_to", "goes to a point of the field and stays there"),
    skill<Position, position>("position", "holds a place relative to ball and field"),
    skill<Block, block>("block", "stands between the ball and the own goal"),
    skill<KeepGoal, keep_goal>("keep_goal",
                               "stays on the arc between ball and goal, steps to a rolling ball, squats to block it"),
    skill<NoArguments, plain<get_ready>>("get_ready", "goes to its place for the kick-off"),
};
constexpr int kBuiltIn = static_cast<int>(std::size(kTable));

}  // namespace

int built_in_skill_count() { return kBuiltIn; }

int skill_count() { return kBuiltIn + static_cast<int>(own_skills().size()); }

const SkillInfo& info_of(Skill skill) {
  const auto index = static_cast<std::size_t>(skill);
  return index < kBuiltIn ? kTable[index] : own_skills()[index - kBuiltIn];
}

Skill find_skill(std::string_view name) {
  for (int i = 0; i < skill_count(); ++i)
    if (name == info_of(static_cast<Skill>(i)).name) return static_cast<Skill>(i);
  return kNoSkill;
}

}  // namespace sim::agent
