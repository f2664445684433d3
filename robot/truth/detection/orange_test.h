// The colour of an orange ball.
#pragma once

#include <cstdint>

#include "robot/truth/detection/detector_options.h"

namespace robot::truth {

/// A test of pixels by hue, saturation and brightness, without a division. Red is the strongest and blue the weakest part of
/// all hues from 0 to 60 degrees.
class OrangeTest {
 public:
  explicit OrangeTest(const Orange& orange)
      : least_hue_(static_cast<float>(orange.least_hue_deg / 60)),
        most_hue_(static_cast<float>(orange.most_hue_deg / 60)),
        least_saturation_(static_cast<float>(orange.least_saturation)),
        least_red_(static_cast<float>(orange.least_brightness * 255)) {}

  /// Reports whether the three bytes of a pixel are orange.
  bool operator()(const std::uint8_t* rgb) const {
    const float red = rgb[0], chroma = static_cast<float>(rgb[0] - rgb[2]),
                yellow = static_cast<float>(rgb[1] - rgb[2]);
    return red >= least_red_ && chroma >= least_saturation_ * red && yellow >= least_hue_ * chroma &&
           yellow <= most_hue_ * chroma;
  }

 private:
  float least_hue_, most_hue_, least_saturation_, least_red_;
};

}  // namespace robot::truth
