#include "sim/contest/conditions.h"

namespace sim::contest {
namespace {

void scale_walk(float factor, motion::Model& model) {
  for (float* const speed : {&model.walk.forward, &model.walk.backward, &model.walk.sideward, &model.walk.turn_rate})
    *speed *= factor;
}

void scale_kicks(float factor, motion::Model& model) {
  for (int i = 0; i < model.kick_count; ++i) model.kicks[i].range *= factor;
}

void scale(const Conditions& conditions, float pace, Models& models) {
  scale_walk(conditions.walk * pace, models.motion);
  scale_kicks(conditions.kick * pace, models.motion);
  perception::Noise& noise = models.perception.noise;
  for (float* const error : {&noise.pixels, &noise.tilt, &noise.tilt_walking, &noise.roll})
    *error *= conditions.ball_noise;
}

}  // namespace

std::vector<Conditions> robust_conditions(bool third) {
  std::vector<Conditions> all = {{.name = "walk x0.8", .walk = 0.8f},
                                 {.name = "walk x1.2", .walk = 1.2f},
                                 {.name = "kick x0.8", .kick = 0.8f},
                                 {.name = "kick x1.2", .kick = 1.2f},
                                 {.name = "ball noise x0.5", .ball_noise = 0.5f},
                                 {.name = "ball noise x2", .ball_noise = 2}};
  if (third) {
    all.push_back({.name = "opponent x0.8", .opponent_pace = 0.8f});
    all.push_back({.name = "opponent x1.2", .opponent_pace = 1.2f});
  }
  return all;
}

void put_upon(const Conditions& conditions, const Side* opponent, Params& params) {
  for (const Side side : {Side::home, Side::away}) {
    Team& team = params.teams[static_cast<int>(side)];
    const float pace = opponent && *opponent == side ? conditions.opponent_pace : 1;
    scale(conditions, pace, team.models);
    for (std::shared_ptr<const Models>& single : team.single) {
      if (!single) continue;
      const auto scaled = std::make_shared<Models>(*single);
      scale(conditions, pace, *scaled);
      single = scaled;
    }
  }
}

}  // namespace sim::contest
