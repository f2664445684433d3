// The field of tests that do not depend on its size.
#pragma once

#include "sim/field/field.h"

namespace sim {

/// The field of 2012: without penalty areas.
inline constexpr field::Field kField2012{.length = 6,
                                         .width = 4,
                                         .border = 0.7f,
                                         .line_width = 0.05f,
                                         .centre_circle_radius = 0.6f,
                                         .goal_area_length = 0.6f,
                                         .goal_area_width = 2.2f,
                                         .penalty_area_length = 0,
                                         .penalty_area_width = 0,
                                         .penalty_mark = 1.3f,
                                         .goal_width = 1.4f,
                                         .goal_depth = 0.4f,
                                         .post_radius = 0.05f};

}  // namespace sim
