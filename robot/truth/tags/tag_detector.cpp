#include "robot/truth/tags/tag_detector.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "robot/core/text.h"
#include "robot/truth/tags/tag_family.h"

namespace robot::truth::tags {
namespace {

/// Returns the brightness of all pixels, 1 byte each (BT.601).
std::vector<std::uint8_t> grey_of(const std::vector<std::uint8_t>& rgb) {
  std::vector<std::uint8_t> grey(rgb.size() / 3);
  const std::uint8_t* pixel = rgb.data();
  for (std::uint8_t& brightness : grey) {
    // 77 + 150 + 29 = 256
    brightness = static_cast<std::uint8_t>((77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2] + 128) / 256);
    pixel += 3;
  }
  return grey;
}

constexpr int kSmallestSide = 32;  // [px] the library divides a picture into tiles and needs a few of them

struct Family {
  std::string_view name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

constexpr std::array<Family, 3> kLibraryFamilies{{{"tag36h11", tag36h11_create, tag36h11_destroy},
                                                  {"tag36h10", tag36h10_create, tag36h10_destroy},
                                                  {"tag25h9", tag25h9_create, tag25h9_destroy}}};

const Family* family_of(std::string_view name) {
  for (const Family& family : kLibraryFamilies)
    if (family.name == name) return &family;
  return nullptr;
}

SeenTag seen_tag(const apriltag_detection_t& detection) {
  SeenTag tag{.id = detection.id, .margin = detection.decision_margin, .corners = {}};
  for (std::size_t corner = 0; corner < 4; ++corner)
    tag.corners[corner] = {detection.p[corner][0], detection.p[corner][1]};
  return tag;
}

}  // namespace

/// The objects of libapriltag.
struct TagDetector::Library {
  explicit Library(const Family& chosen, const DetectorOptions& options)
      : destroy_family(chosen.destroy),
        family(chosen.create()),
        detector(apriltag_detector_create()),
        least_margin(options.least_margin) {
    // no corrected bit: a wrong identity is worse than a tag that is missed once
    apriltag_detector_add_family_bits(detector, family, 0);
    detector->nthreads = std::max(1, options.threads);
    detector->quad_decimate = static_cast<float>(std::max(1.0, options.shrink));
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() {
    apriltag_detector_destroy(detector);
    destroy_family(family);
  }

  void (*destroy_family)(apriltag_family_t*);
  apriltag_family_t* family;
  apriltag_detector_t* detector;
  double least_margin;
};

bool sees_tags() { return true; }

Result<TagDetector> TagDetector::create(const DetectorOptions& options) {
  const Family* family = family_of(options.family);
  if (!family)
    return Error{
        formatted("tag family: expected %s, got '%s'", family_names().c_str(), printable(options.family, 40).c_str())};
  return TagDetector(std::make_unique<Library>(*family, options));
}

TagDetector::TagDetector(std::unique_ptr<Library> library) : library_(std::move(library)) {}
TagDetector::TagDetector(TagDetector&&) noexcept = default;
TagDetector& TagDetector::operator=(TagDetector&&) noexcept = default;
TagDetector::~TagDetector() = default;

std::vector<SeenTag> TagDetector::detect(const DepthFrame& picture) {
  std::vector<SeenTag> tags;
  if (picture.intrinsics.width < kSmallestSide || picture.intrinsics.height < kSmallestSide) return tags;
  std::vector<std::uint8_t> grey = grey_of(picture.rgb);
  image_u8_t image{picture.intrinsics.width, picture.intrinsics.height, picture.intrinsics.width, grey.data()};
  zarray_t* detections = apriltag_detector_detect(library_->detector, &image);
  for (int i = 0; i < zarray_size(detections); ++i) {
    const apriltag_detection_t* detection = nullptr;
    zarray_get(detections, i, static_cast<void*>(&detection));
    if (detection->hamming == 0 && detection->decision_margin >= library_->least_margin)
      tags.push_back(seen_tag(*detection));
  }
  apriltag_detections_destroy(detections);
  return tags;
}

}  // namespace robot::truth::tags
