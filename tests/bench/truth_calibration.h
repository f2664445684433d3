// Monte Carlo trials of the calibration of a depth sensor, on synthetic images.
#pragma once

namespace bench {

/// Calibrates `trials` times with clicks of `click_deviation` [px], by a sensor that measures its depths `scale` times too
/// far. Prints one line of JSON with the errors of robots (by depth) and ball (by bearing) near the field's centre [cm].
/// "coverage" is the share of errors within the 95 % ellipse of the covariance.
void calibration_trials(int trials, double click_deviation, double scale);

}  // namespace bench
