#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "robot/core/text.h"
#include "robot/fit/ball_noise/image_noise.h"
#include "robot/fit/checking/checks.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestNoisy = 40, kFewestNoisyPasses = 8;  // as in the fit of the noise
constexpr std::size_t kPassSamples = 100;
constexpr int kNoiseRounds = 8;           // draws of all images, for the mean
constexpr double kNoiseTolerance = 0.02;  // of a deviation: the errors of the truth are known to that

/// A standard deviation of percepts, and the images that show it.
struct NoisePart {
  const char* name;
  bool of_bearing, of_standing, of_moving;
};
constexpr std::array<NoisePart, 3> kNoiseParts{{{"vision: deviation of the elevation, standing", false, true, false},
                                                {"vision: deviation of the elevation, walking", false, false, true},
                                                {"vision: deviation of the bearing", true, true, true}}};

/// One error beside the median of its recording, and the deviation of the models with the error of the truth.
struct NoisyImage {
  double error = 0, deviation = 0;  // [rad]
};

/// The images of one part, in their passes.
struct NoisyImages {
  std::vector<NoisyImage> images;
  std::vector<Group> passes;
};

NoisyImages images_of(const ImageNoiseFit& fit, const NoisePart& part, const ImageNoise& noise, double pixels) {
  NoisyImages chosen;
  for (const Group& pass : fit.passes) {
    Group group;
    for (const std::size_t i : pass) {
      const ImageError& one = fit.errors[i];
      const ImageBias& bias = fit.biases[one.recording];
      const double error = part.of_bearing ? one.bearing - bias.bearing : one.elevation - bias.elevation;
      if (!std::isfinite(error) || !(one.standing ? part.of_standing : part.of_moving)) continue;
      const double model = part.of_bearing ? noise.roll : one.standing ? noise.tilt : noise.tilt_walking;
      group.push_back(chosen.images.size());
      chosen.images.push_back(
          {.error = error,
           .deviation = std::hypot(model, std::hypot(pixels, part.of_bearing ? one.of_bearing : one.of_elevation))});
    }
    if (!group.empty()) chosen.passes.push_back(std::move(group));
  }
  return chosen;
}

double deviation_by_median(std::vector<double> errors) {
  for (double& error : errors) error = std::abs(error);
  return kOfMedian * lab::median_of(std::move(errors));
}

/// Returns the deviation that the models let expect.
double expected_deviation(const NoisyImages& chosen, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> errors;
  for (int round = 0; round < kNoiseRounds; ++round)
    for (const NoisyImage& image : chosen.images) errors.push_back(image.deviation * normal(random));
  return deviation_by_median(std::move(errors));
}

Statistic check_part(const NoisyImages& chosen, const char* name) {
  const auto recorded = [&](const std::vector<std::size_t>& images) -> Vector {
    std::vector<double> errors;
    errors.reserve(images.size());
    for (const std::size_t i : images) errors.push_back(chosen.images[i].error);
    return {deviation_by_median(std::move(errors))};
  };
  Statistic statistic{.name = name,
                      .unit = "rad",
                      .recorded = recorded(all_of(chosen.images.size()))[0],
                      .simulated = {},
                      .events = chosen.passes.size(),
                      .kind = "passes"};
  std::mt19937_64 random(10);
  const double expected = expected_deviation(chosen, random);
  const double luck = deviations_of(resampled(chosen.passes, kPassSamples, recorded))[0];
  std::normal_distribution<double> drawn(expected, std::hypot(luck, kNoiseTolerance * expected));
  for (std::size_t i = 0; i < kCheckSamples; ++i) statistic.simulated.push_back(drawn(random));
  return statistic;
}

}  // namespace

std::vector<Statistic> check_noise(const BallPlaces& places, const sim::Models& models,
                                   std::vector<std::string>& missing) {
  const sim::perception::Noise& model = models.perception.noise;
  ImageNoise noise{.tilt = model.tilt, .tilt_walking = model.tilt_walking, .roll = model.roll};
  const ImageFacts facts = image_facts(models);
  const ImageNoiseFit fit = fit_image_noise(places, facts, noise);
  const double pixels = models.effects.ball_noise ? facts.pixels : 0;
  if (!models.effects.ball_noise) noise = {};
  std::vector<Statistic> all;
  for (const NoisePart& part : kNoiseParts) {
    const NoisyImages chosen = images_of(fit, part, noise, pixels);
    if (chosen.images.size() >= kFewestNoisy && chosen.passes.size() >= kFewestNoisyPasses)
      all.push_back(check_part(chosen, part.name));
    else
      missing.push_back(formatted("%s: expected at least %zu images of a ball that lies, in %zu passes, got %zu in %zu",
                                  part.name, kFewestNoisy, kFewestNoisyPasses, chosen.images.size(),
                                  chosen.passes.size()));
  }
  return all;
}

}  // namespace robot::fit
