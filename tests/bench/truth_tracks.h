// Accuracy of the tracks of ground truth: each returns one line of JSON.
#pragma once

#include <string>

/// Velocity of a kicked ball, online and smoothed [m/s rms]: 30 Hz, position noise 1 cm, 5 % of the images miss it.
std::string kicked_ball();

/// Identity switches in ten minutes of 4v4, without and with the robots' own poses.
std::string identity_switches();

/// Normalised squared errors of things that move as the filter expects, and of games.
std::string consistency();

/// Processor time of one image with ten robots [ms].
std::string cost();
