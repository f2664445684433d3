#include "robot/truth/sensor/open_source.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/core/text.h"
#include "robot/truth/sensor/camera_file.h"
#include "robot/truth/sensor/freenect_driver.h"
#include "robot/truth/sensor/live_source.h"
#include "robot/truth/sensor/openni_driver.h"
#include "robot/truth/sensor/ordinary_camera.h"
#include "robot/truth/sensor/recording.h"
#include "robot/truth/sensor/video_driver.h"

namespace robot::truth {
namespace {

using Opened = Result<std::unique_ptr<DepthSource>>;

constexpr std::string_view kPictures = "pictures", kCamera = "camera";

/// An address KIND:PLACE, or KIND:PLACE@CAMERA_FILE of a live source.
struct Address {
  std::string whole, place;
};

using OpenKind = Opened (*)(const Address&);

struct SourceKind {
  std::string_view name, place, purpose;
  OpenKind open;             // nullptr: not in this build
  std::string_view package;  // with the driver's headers, if it may be missing
};

using MakeDriver = Result<std::unique_ptr<SensorDriver>> (*)(const std::string& place, const CameraFile& camera);

/// Opens a live source. The camera file is read now, so that a wrong one is reported at once.
Opened open_live(const Address& address, MakeDriver make_driver) {
  const std::size_t at = address.place.rfind('@');
  CameraFile camera;
  if (at != std::string::npos) {
    Result<CameraFile> read = read_camera_file(address.place.substr(at + 1));
    if (!read) return read.failure();
    camera = *std::move(read);
  }
  Result<std::unique_ptr<SensorDriver>> driver = make_driver(address.place.substr(0, at), camera);
  if (!driver) return driver.failure(address.whole);
  return std::unique_ptr<DepthSource>(
      std::make_unique<LiveSource>(address.whole, *std::move(driver), std::move(camera)));
}

#if FORESIGHT_FREENECT
Opened open_freenect(const Address& address) {
  return open_live(address, [](const std::string& place, const CameraFile&) -> Result<std::unique_ptr<SensorDriver>> {
    unsigned char number = 0;
    const auto [end, error] = std::from_chars(place.data(), place.data() + place.size(), number);
    if (error == std::errc() && end == place.data() + place.size()) return freenect_driver(number);
    return Error{"expected the number of a Kinect, from 0 on, got \"" + printable(place, 40) + "\""};
  });
}
constexpr OpenKind kOpenFreenect = open_freenect;
#else
constexpr OpenKind kOpenFreenect = nullptr;
#endif

#if FORESIGHT_OPENNI
Opened open_openni(const Address& address) {
  return open_live(address, [](const std::string& place, const CameraFile&) -> Result<std::unique_ptr<SensorDriver>> {
    return openni_driver(place);
  });
}
constexpr OpenKind kOpenOpenni = open_openni;
#else
constexpr OpenKind kOpenOpenni = nullptr;
#endif

Opened open_camera(const Address& address) {
  return open_live(address, [](const std::string& place, const CameraFile& camera) {
    return Result(picture_driver(place, static_cast<std::uint32_t>(camera.width.value_or(1280)),
                                 static_cast<std::uint32_t>(camera.height.value_or(720)),
                                 std::make_unique<nao::KernelVideoDevice>()));
  });
}

Opened open_video(const Address& address) {
  return open_live(address, [](const std::string& place, const CameraFile& camera) {
    return Result(video_driver(place, static_cast<std::uint32_t>(camera.width.value_or(640)),
                               static_cast<std::uint32_t>(camera.height.value_or(480)),
                               std::make_unique<nao::KernelVideoDevice>()));
  });
}

const std::vector<SourceKind>& source_kinds() {
  static const std::vector<SourceKind> kinds = {
      {"fakenect", "FOLDER", "a recording of fakenect-record (the first Kinect)",
       [](const Address& address) { return open_fakenect(address.whole, address.place); }, ""},
      {"folder", "FOLDER", "images of 16 bits: *.png, *.pgm, *.tif, *.tiff, with or without camera.json",
       [](const Address& address) { return open_image_folder(address.whole, address.place); }, ""},
      {"pclzf", "FOLDER", "a recording of PCL: *_depth.pclzf, *.xml, *_rgb.pclzf",
       [](const Address& address) { return open_pclzf(address.whole, address.place); }, ""},
      {kPictures, "FOLDER", "pictures by name, with --tags: *.jpg, *.png, *.ppm",
       [](const Address& address) { return open_picture_folder(address.whole, address.place); }, ""},
      {"freenect", "N", "the first Kinect, through libfreenect", kOpenFreenect, "libfreenect-dev"},
      {"openni", "N", "a sensor of PrimeSense, Asus or Orbbec, through OpenNI 2", kOpenOpenni, "libopenni2-dev"},
      {"v4l2", "DEVICE", "a depth camera of the kernel (Z16), such as /dev/video2", open_video, ""},
      {kCamera, "DEVICE", "a colour camera of the kernel (MJPEG or YUYV), with --tags", open_camera, ""},
  };
  return kinds;
}

std::string absence(const SourceKind& kind) {
  return "not in this build, " + std::string(kind.package) + " was missing";
}

}  // namespace

Result<std::unique_ptr<DepthSource>> open_source(const std::string& address) {
  const std::string name = address.substr(0, address.find(':'));
  const auto& kinds = source_kinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const SourceKind& known) { return known.name == name; });
  if (kind == kinds.end() || name.size() == address.size()) {
    std::vector<std::string> known;
    for (const SourceKind& each : kinds) known.push_back(formatted("%s:%s", each.name.data(), each.place.data()));
    return Error{"source \"" + printable(address, 60) + "\": expected " + joined(known, ", ")};
  }
  if (!kind->open) return Error{name + ": " + absence(*kind)};
  return kind->open({address, address.substr(name.size() + 1)});
}

bool is_ordinary_camera(const std::string& address) {
  const std::string_view kind = std::string_view(address).substr(0, address.find(':'));
  return kind == kPictures || kind == kCamera;
}

std::string describe_sources() {
  std::string lines;
  for (const SourceKind& kind : source_kinds()) {
    const std::string address = formatted("%s:%s", kind.name.data(), kind.place.data());
    const std::string purpose = kind.open ? std::string(kind.purpose) : absence(kind);
    lines += formatted("  %-16s %s\n", address.c_str(), purpose.c_str());
  }
  return lines;
}

}  // namespace robot::truth
