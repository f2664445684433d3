// The messages of a calibration in the browser: clicks from a client, the answer to it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/calibration/calibrate.h"

namespace robot::truth {

/// The greatest number of clicks in a message or a file.
inline constexpr std::size_t kMostClicks = 200;

/// Returns the clicks of {"clicks": [{"landmark": "corner +x +y", "x": 12.5, "y": 33}, …]}; other members are left alone.
Result<std::vector<Click>> clicks_of(const nlohmann::json& message);

/// Parses the same from text: a message's, or that of a file of clicks.
Result<std::vector<Click>> parse_clicks(std::string_view text);

/// Returns the message that clicks_of() reads.
nlohmann::json to_json(const std::vector<Click>& clicks);

/// Returns the answer to clicks. "refused" is empty for a good calibration.
/// An Error becomes {"fitted": false, "refused": the sentence}.
///
/// {"fitted", "refused", "residuals": [{"landmark", "pixels", "outlier"}], "depth_scale", "depth_scale_deviation",
/// "error": {"mean", "p95", "grid": [{"x", "y", "metres"}]}, "ball_error": the same, "left_out": {"mean", "worst",
/// "landmark"}, "place": {"rotation": [9 numbers row by row], "x", "y", "z"}}
nlohmann::json to_json(const Result<Calibration>& calibration);

/// Returns [{"name", "x", "y", "z"}, …] [m, field].
nlohmann::json to_json(const std::vector<Landmark>& landmarks);

}  // namespace robot::truth
