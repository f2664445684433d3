#include "sim/agent/skills.h"

#include <iterator>

#include "sim/agent/ball_skills.h"
#include "sim/agent/head.h"
#include "sim/agent/own.h"
#include "sim/agent/place_skills.h"
#include "sim/agent/search.h"

namespace sim::agent {
namespace {

constexpr const char* kAims[] = {"goal", "opening", "ahead", "away", "mate", nullptr};

constexpr ParameterInfo number(const char* name, const char* unit, float least, float most, float standard,
                               const char* about) {
  return {name, unit, least, most, standard, false, nullptr, about};
}
constexpr ParameterInfo lateral(const char* name, const char* unit, float most, const char* about) {
  return {name, unit, -most, most, 0, true, nullptr, about};
}
constexpr ParameterInfo aim(Aim standard) {
  return {"aim", "", 0, 4, static_cast<float>(standard), false, kAims, "where the ball shall go"};
}
constexpr ParameterInfo tolerance(float standard) {
  return number("tolerance", "rad", 0.01f, 3.f, standard, "the direction of the ball may be so far off the aim");
}
constexpr ParameterInfo range(float standard) {
  return number("range", "m", 0, 12, standard, "the quickest kick that carries so far, else the longest");
}
constexpr ParameterInfo care(float standard) {
  return number("care", "", 0.2f, 2, standard, "of the kick's gate in which the ball must lie");
}
constexpr ParameterInfo frames() {
  return number("frames", "decisions", 1, 30, 1, "in a row in which it must lie there");
}
constexpr ParameterInfo gain() { return number("gain", "", 0.1f, 1, 1, "share of the greatest speed"); }
constexpr ParameterInfo spread(float standard) {
  return number("spread", "m", 0, 5, standard, "between the lanes of robots of the same role");
}

// in the order of the enumeration; the parameters in the order of the structs in *_skills.h
constexpr SkillInfo kTable[] = {
    {"stand", "stands, the head at the ball or searching", 0, {}},
    {"search_ball", "scans, turns, then walks about", 1, {gain()}},
    {"look_round", "stands and looks for marks", 1, {number("angle", "rad", 0.1f, 2, 1, "to each side")}},
    {"walk_to_ball",
     "goes behind the ball, round it where it must",
     4,
     {aim(Aim::opening), tolerance(0.2f), number("distance", "m", 0.15f, 3, 0.3f, "from the ball"), gain()}},
    {"align",
     "stands so that a kick would send the ball to the aim",
     3,
     {aim(Aim::opening), tolerance(0.05f), range(3)}},
    {"kick",
     "aligns and kicks as soon as the ball lies right",
     5,
     {aim(Aim::opening), tolerance(0.2f), range(3), care(1), frames()}},
    {"dribble", "walks the ball towards the aim", 3, {aim(Aim::opening), tolerance(0.3f), gain()}},
    {"pass",
     "kicks to the free teammate, or on as `ahead` where there is none",
     4,
     {tolerance(0.15f), number("lead", "m", -1, 3, 0.4f, "in front of the teammate"), care(1), frames()}},
    {"position",
     "holds a place relative to ball and field",
     8,
     {number("base", "", -1, 1, 0, "share of the half field, -1 at the own goal"),
      number("follow_x", "", 0, 1, 0.5f, "share of the ball's x"), number("x", "m", -8, 8, 0, "beyond that"),
      number("follow_y", "", -1, 1, 0.5f, "share of the ball's y"), lateral("y", "m", 4, "beyond that, to the left"),
      spread(1.2f), number("distance", "m", 0, 4, 0.8f, "from the ball, at least"), gain()}},
    {"block",
     "stands between the ball and the own goal",
     4,
     {number("share", "", 0.05f, 0.95f, 0.5f, "of the way from the goal to the ball"),
      number("distance", "m", 0, 4, 0.6f, "from the ball, at least"), spread(0.8f), gain()}},
    {"keep_goal",
     "stays on the arc between ball and goal, goes to where a rolling ball passes, squats to block it",
     4,
     {number("radius", "m", 0.1f, 3, 0.5f, "of the arc round the goal's middle"),
      number("step", "m", 0.03f, 1, 0.12f, "off the place before it moves"),
      number("squat_time", "s", 0, 3, 0.8f, "before a ball passes, to squat; 0: never"),
      number("squat_reach", "m", 0, 1, 0.32f, "beside the feet at which it passes, to squat")}},
    {"get_ready", "goes to its place for the kick-off", 0, {}},
};
static_assert(std::size(kTable) == kSkillCount);

const OwnSkill& own(Skill skill) { return own_skills()[static_cast<std::size_t>(skill) - kSkillCount]; }

}  // namespace

int skill_count() { return kSkillCount + static_cast<int>(own_skills().size()); }

const SkillInfo& info_of(Skill skill) {
  return skill < Skill::count ? kTable[static_cast<int>(skill)] : own(skill).info;
}

Skill find_skill(std::string_view name) {
  for (int i = 0; i < skill_count(); ++i)
    if (name == info_of(static_cast<Skill>(i)).name) return static_cast<Skill>(i);
  return kNoSkill;
}

motion::Command run(Skill skill, const float* with, const View& view, Mind& mind) {
  switch (skill) {
    case Skill::search_ball: return search_ball(view, mind, with[0]);
    case Skill::look_round: return look_round(view, with[0]);
    case Skill::walk_to_ball: return walk_to_ball(view, mind, {as_aim(with[0]), with[1], with[2], with[3]});
    case Skill::align: return align(view, mind, {as_aim(with[0]), with[1], with[2]});
    case Skill::kick: return kick(view, mind, {as_aim(with[0]), with[1], with[2], with[3], with[4]});
    case Skill::dribble: return dribble(view, mind, {as_aim(with[0]), with[1], with[2]});
    case Skill::pass: return pass(view, mind, {with[0], with[1], with[2], with[3]});
    case Skill::position:
      return position(view, {with[0], with[1], with[2], with[3], with[4], with[5], with[6], with[7]});
    case Skill::block: return block(view, {with[0], with[1], with[2], with[3]});
    case Skill::keep_goal: return keep_goal(view, {with[0], with[1], with[2], with[3]});
    case Skill::get_ready: return get_ready(view);
    case Skill::stand: return stand(view);
    case Skill::count: break;
  }
  return own(skill).run(with, view, mind);
}

}  // namespace sim::agent
