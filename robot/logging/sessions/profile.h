// Recording profiles: the choice of camera images, and the disk space that it takes.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/image/image_codec.h"
#include "robot/logging/streams/provider.h"

namespace robot::logging {

/// The schema of camera images. Their chunks are not compressed: raw images hardly get smaller, and JPEG is compressed
/// already.
inline constexpr std::string_view kImageSchema = "foresight.Image";

/// A profile of recording. Every profile records all objects; profiles differ in the camera images.
struct Profile {
  std::string_view name;
  std::string_view purpose;
  bool raw_images;          // as the camera delivers them
  image::JpegOptions jpeg;  // otherwise
  float images_per_second;  // of each camera, at most
  /// [10^6 bytes] size of both cameras at 30 Hz and of all objects, measured by `scripts/bench half`.
  double mb_per_minute;
};

/// Returns all profiles, the smallest first.
std::span<const Profile> profiles();

/// Returns the profile of that name, or an Error that lists all names.
Result<Profile> profile_named(std::string_view name);

/// Wraps the stream of a camera to write the images of `profile`: fewer, smaller, as JPEG.
/// The wrapper numbers the messages itself, so that a gap in the numbers still means a loss.
std::unique_ptr<OutProvider> thin_images(const Profile& profile, std::unique_ptr<OutProvider> stream);

}  // namespace robot::logging
