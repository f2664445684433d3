// The services with which the viewer calibrates a sensor and makes it learn the empty field.
#pragma once

#include <memory>
#include <vector>

#include "robot/app/truth/calibrations.h"
#include "robot/app/truth/sensor_watch.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// Adds these services. `watches` and `calibrations` outlive the server.
///
///   /truth/landmarks  {"sensor": 1}  -> {"ok", "landmarks": [{"name", "x", "y", "z"}], "clicks": [{"landmark", "x", "y"}],
///                                        "file"}
///
/// "clicks" are those of the saved calibration; "file" is its name, or empty if nothing can be saved.
///
///   /truth/calibrate  {"sensor": 1, "clicks": [{"landmark": "corner +x +y", "x": 12.5, "y": 33}, …], "save": false}
///                     -> {"ok", "saved", …}
///
/// with the members of robot/truth/calibration/calibration_json.h. The newest image gives the carpet. With "save", a good
/// calibration is written to the file, whose name is "saved", and the sensor uses it at once. A refused one is not saved.
///
///   /truth/background  {"sensor": 1}  -> {"ok", "images"}
///
/// The sensor takes this number of its next images as the empty field. TruthSensor counts them.
void add_calibration_services(net::Services& services, const CalibratedField& on,
                              const std::vector<std::unique_ptr<SensorWatch>>& watches, Calibrations& calibrations);

}  // namespace robot::app
