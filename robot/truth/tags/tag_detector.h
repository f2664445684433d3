// Printed tags in a picture: their ids and corners.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/tags/seen_tag.h"

namespace robot::truth::tags {

struct DetectorOptions {
  std::string family = "tag36h11";
  int threads = 1;

  /// The factor by which the picture is made smaller for the search. 1.5 halves the time and loses 4 of 100 tags of 12 to
  /// 16 cm at 3 m; 2 loses 18 (tests/bench/truth_tags.cpp). The corners are always refined at full size.
  double shrink = 1;

  double least_margin = 20;  // a tag of less contrast is not reported
};

/// Reports whether this build can see printed tags.
bool sees_tags();

/// A detector of one family. It reports only codes without a wrong bit, so that no tag is taken for another one.
/// Used by one thread. Without libapriltag at build time create() returns an Error that says so.
class TagDetector {
 public:
  static Result<TagDetector> create(const DetectorOptions& options);
  TagDetector(TagDetector&&) noexcept;
  TagDetector& operator=(TagDetector&&) noexcept;
  ~TagDetector();

  /// Returns all tags, in the order of the library. The same id may be there twice.
  std::vector<SeenTag> detect(const DepthFrame& picture);

 private:
  struct Library;
  explicit TagDetector(std::unique_ptr<Library> library);
  std::unique_ptr<Library> library_;
};

}  // namespace robot::truth::tags
