// Accuracy and cost of the tracks of ground truth. Each function returns one line of JSON.
#pragma once

#include <string>

/// Velocity of a ball that rolls after kicks and rebounds, online and smoothed [m/s rms], in ten minutes of a game.
/// The noise is 1 cm; 30 images come a second, 5 % of them without the ball. The images around a contact do not count: it has no velocity.
/// `followed_share` are the kicks that are followed within 30 % of their velocity, by the count of images since then.
std::string kicked_ball();

/// Identity switches in ten minutes of 4v4, the most of three games: of tracks, and of players with own poses.
std::string identity_switches();

/// Mean normalised squared errors of place and velocity, and the 95 % band around 4: robots that walk as the filter expects.
/// Then the variance of two sensors relative to that of one, and errors of robots in a game.
std::string consistency();

/// Processor time of an image of one of two sensors with ten robots [ms].
std::string cost_of_an_image();
