// The stand-in for a build without libapriltag.
#include "robot/truth/tags/tag_detector.h"

namespace robot::truth::tags {

struct TagDetector::Library {};

bool sees_tags() { return false; }

Result<TagDetector> TagDetector::create(const DetectorOptions&) {
  return Error{"printed tags are not in this build: install libapriltag-dev, then configure and build again"};
}

TagDetector::TagDetector(std::unique_ptr<Library> library) : library_(std::move(library)) {}
TagDetector::TagDetector(TagDetector&&) noexcept = default;
TagDetector& TagDetector::operator=(TagDetector&&) noexcept = default;
TagDetector::~TagDetector() = default;

std::vector<SeenTag> TagDetector::detect(const DepthFrame&) { return {}; }

}  // namespace robot::truth::tags
