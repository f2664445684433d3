// What is recorded, and how much room that takes.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/image/image_codec.h"
#include "robot/logging/streams/provider.h"

namespace robot::logging {

/// The schema of camera images, which are recorded without compression: raw ones are noise to it, JPEG has its own.
inline constexpr std::string_view kImageSchema = "foresight.Image";

/// A way of recording. All objects are always recorded; profiles differ in what becomes of the camera images.
struct Profile {
  std::string_view name;
  std::string_view purpose;
  bool raw_images;          // as the camera delivers them
  image::JpegOptions jpeg;  // otherwise
  float images_per_second;  // of each camera, at most
  double
      mb_per_minute;  // [10^6 bytes] what both cameras at 30 Hz and all objects take; measured by `scripts/bench half`
};

/// All profiles, the smallest first.
std::span<const Profile> profiles();

/// The profile of that name; an Error that names all there are.
Result<Profile> profile_named(std::string_view name);

/// Wraps the stream of a camera so that it takes the images as `profile` wants them: fewer, smaller, as JPEG.
/// Messages of a thinned stream are numbered anew, so that a gap still tells of a loss.
std::unique_ptr<OutProvider> thin_images(const Profile& profile, std::unique_ptr<OutProvider> stream);

}  // namespace robot::logging
