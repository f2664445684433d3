// Every source of depth images, by its address.
//
//   fakenect:FOLDER   a recording of fakenect-record: INDEX.txt, d-*.pgm, r-*.ppm
//   folder:FOLDER     images of 16 bits (*.png, *.pgm, *.tif, *.tiff) in the order of their names
//   pclzf:FOLDER      a recording of PCL: *_depth.pclzf with *.xml, and *_rgb.pclzf where it exists
//   pictures:FOLDER   pictures of an ordinary camera: *.jpg, *.png, *.ppm
//   freenect:N        the Nth first-generation Kinect, from 0 on
//   openni:N          the Nth sensor of OpenNI 2, from 0 on; or one of its own addresses (URI)
//   v4l2:DEVICE       a depth camera that the kernel drives (format Z16): v4l2:/dev/video2
//   camera:DEVICE     an ordinary camera that the kernel drives (MJPEG or YUYV): camera:/dev/video0
//
// A live source may have a camera file behind an @, whose intrinsics replace the driver's: v4l2:/dev/video2@d435.json. A
// `folder` takes the file camera.json within it; camera_file.h lists the entries. Without one, the images of a folder have
// the Kinect's pinhole and millimetres. Their times come from the camera file, otherwise from their names (name_time.h);
// images without a time come 30 times a second from the epoch on.
//
// All black images, and those without a disparity in any pixel, are valid: nothing was measured.
#pragma once

#include <memory>
#include <string>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_source.h"

namespace robot::truth {

/// Opens the source at this address. A live sensor is opened by the first next(), so that it may be plugged in later.
/// Returns an Error for an unknown kind, one that this build lacks, and a recording without images.
Result<std::unique_ptr<DepthSource>> open_source(const std::string& address);

/// Reports whether the address is one of an ordinary camera, whose images have no depths: "camera:…", "pictures:…".
bool is_ordinary_camera(const std::string& address);

/// Returns one line for each kind of source, for --help. A kind that this build lacks names the missing package.
std::string describe_sources();

}  // namespace robot::truth
