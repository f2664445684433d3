// Monte Carlo trials of the calibration of a depth sensor, on synthetic images.
#pragma once

namespace bench {

/// Calibrates `trials` times with clicks of `click_deviation` [px], by a sensor that measures its depths `scale` times too
/// far. Prints one line of JSON: errors of robots (by depth) and ball (by bearing) over the field within 1.5 m of its centre
/// [cm], the share of errors within the 95 % ellipse of the covariance, and the processor time of a calibration.
void calibration_trials(int trials, double click_deviation, double scale);

}  // namespace bench
