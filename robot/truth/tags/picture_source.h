// The interface of everything that delivers pictures: a camera, a folder.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/truth/tags/picture.h"

namespace robot::truth::tags {

/// A source of pictures, as robot/truth/frame/depth_source.h is of depth images. Used by one thread.
class PictureSource {
 public:
  PictureSource() = default;
  PictureSource(const PictureSource&) = delete;
  PictureSource& operator=(const PictureSource&) = delete;
  virtual ~PictureSource() = default;

  /// Waits for the next picture, at most a second. Returns nothing at the end of a folder. Returns an Error, once for each
  /// damaged picture or each second without a camera. The next call continues after the damage, or opens the camera
  /// again. A folder does not pace itself.
  virtual Result<std::optional<Picture>> next() = 0;

  /// Returns the address by which it was opened: "camera:/dev/video0", "pictures:logs/field".
  virtual const std::string& address() const = 0;

  /// Reports whether the pictures are of this moment, not recorded.
  virtual bool live() const = 0;
};

/// Reports whether the address is one of a source of pictures: "camera:…" or "pictures:…".
bool is_picture_address(const std::string& address);

/// Opens a source. A camera is asked for pictures of `size`, that of its calibration; it may be plugged in later. The times
/// of a camera are those of `clock`, which outlives the source. Returns an Error for another address, and for a folder that
/// cannot be read or has no picture.
Result<std::unique_ptr<PictureSource>> open_pictures(const std::string& address, PictureSize size,
                                                     const SessionClock& clock);

}  // namespace robot::truth::tags
