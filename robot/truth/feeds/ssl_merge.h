// The views of several cameras as one world.
#pragma once

#include <optional>
#include <vector>

#include "proto/foresight/truth.pb.h"
#include "robot/truth/feeds/ssl_packet.h"

namespace robot::truth {

/// Robots nearer than this [m] are one robot that several cameras see. Two robots cannot be as near.
inline constexpr double kSameRobot = 0.1;

/// Balls nearer than this [m] are one ball.
inline constexpr double kSameBall = 0.05;

/// Merges the views, each of another camera.
///
/// Sightings of one thing are averaged by their confidence, and the greatest confidence counts. Robots of one team with the
/// same player are one. If they are farther apart than kSameRobot, the most confident one counts, and `disagreements` has a
/// sentence. The ball is the most confident one within the border of `field`; absent: any.
foresight::GroundTruth merge(const std::vector<SslView>& views, const std::optional<SslField>& field);

}  // namespace robot::truth
