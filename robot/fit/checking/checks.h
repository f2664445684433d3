// The situations of recordings, simulated with given models. Pure.
//
// Each function returns the statistics that its situations show; with too few of them it adds a sentence to `missing` instead.
// All draws have fixed seeds.
#pragma once

#include <string>
#include <vector>

#include "robot/fit/ball_noise/ball_places.h"
#include "robot/fit/checking/statistic.h"
#include "robot/fit/falling/falling.h"
#include "robot/fit/kicks/kicks.h"
#include "robot/fit/radio/packets.h"
#include "robot/fit/rolling/rolls.h"
#include "robot/fit/visibility/false_balls.h"
#include "robot/fit/visibility/sights.h"
#include "robot/fit/walking/drives.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Replays the recorded commands in the simulator's mean walk, with the luck of the steps, a pace for each robot, the error of its
/// clock and that of the truth. Statistics: the mean over robots of the speed ahead, back, to a side, and of the turn rate; the
/// speed ahead of the fastest of at least three robots. A robot counts with two seconds, five stretches in all are enough.
std::vector<Statistic> check_walk(const Drives& drives, const sim::Models& models, std::vector<std::string>& missing);

/// Draws each kick that counts from the model of its kind, with its errors of observation. Kicks slower than `slowest` count neither
/// here nor there. Statistics of each kind with five kicks or more: the mean landing distance and its 90 % quantile, the median
/// direction and the deviation from it. The deviation is by the median of the distances. A kick that was tracked wrong
/// counts as twice the range of its kind at most.
std::vector<Statistic> check_kicks(const std::vector<KickFit>& seen, const sim::Models& models,
                                   std::vector<std::string>& missing);

/// Draws the deceleration of each roll with its error and the spread between the recorded rolls, since the models have no spread.
/// Statistic: their median; five rolls are enough.
std::vector<Statistic> check_rolls(const std::vector<Roll>& rolls, const sim::Models& models,
                                   std::vector<std::string>& missing);

/// Draws the number of falls in the time that robots walked and touched each other. Also draws the failures to get up, and the
/// median times of lying and of an attempt to get up, with their recorded spread. Five minutes of walking or touching are enough,
/// and five attempts.
std::vector<Statistic> check_falls(const FallsSeen& seen, const sim::Models& models, std::vector<std::string>& missing);

/// Draws the delays and losses of packets. Statistics: the mean delay, the share of packets that a mate does not hear; 50 packets
/// are enough. Where the receivers of a packet share more than the models say, the intervals are wider. So are they by the
/// clocks' errors.
std::vector<Statistic> check_packets(const std::vector<TeamRecord>& records, const sim::Models& models,
                                     std::vector<std::string>& missing);

/// Draws the images that show a ball in view, for each range of distances with ten passes. Images count by themselves, as in the
/// models, or as whole passes if these differ more.
std::vector<Statistic> check_sights(const Sights& sights, const sim::Models& models, std::vector<std::string>& missing);

/// Draws the errors of percepts of balls that lie, with those of truth and clock. Statistics: the deviation of the elevation, standing
/// and walking, and that of the bearing, each by the median of the distances from the median of its recording. The intervals
/// cover the luck of whole passes, as it was recorded.
std::vector<Statistic> check_noise(const BallPlaces& places, const sim::Models& models,
                                   std::vector<std::string>& missing);

/// Draws the number of false balls in at least a minute of images that would show one.
std::vector<Statistic> check_false_balls(const Looks& looks, const sim::Models& models,
                                         std::vector<std::string>& missing);

}  // namespace robot::fit
