// Any bytes as a file of a depth recording. The first byte chooses the reader.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/truth/sensor/camera_file.h"
#include "robot/truth/sensor/colour_codec.h"
#include "robot/truth/sensor/fakenect.h"
#include "robot/truth/sensor/kinect.h"
#include "robot/truth/sensor/lzf.h"
#include "robot/truth/sensor/name_time.h"
#include "robot/truth/sensor/netpbm.h"
#include "robot/truth/sensor/pcl_camera.h"
#include "robot/truth/sensor/pclzf.h"
#include "robot/truth/sensor/png.h"
#include "robot/truth/sensor/tiff.h"

namespace {

using namespace robot::truth;

/// Reads the disparities of a depth image, if they are some, and takes a colour image of any size for its colours.
void convert(std::string_view bytes) {
  const auto disparities = read_fakenect_pgm(bytes);
  const ColourImage colour{3, 2, std::vector<std::uint8_t>(18)};
  if (disparities) kinect_frame(*disparities, &colour).operator bool();
}

/// Reads names, and the index of their names.
void read_names(std::string_view bytes) {
  for (const std::string_view name : parse_fakenect_index(bytes)) parse_fakenect_name(name).operator bool();
  static_cast<void>(time_in_name(bytes));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 10) {
    case 0: read_pgm(bytes).operator bool(); break;
    case 1: convert(bytes); break;
    case 2: read_colour(bytes).operator bool(); break;
    case 3: read_png(bytes).operator bool(); break;
    case 4: read_tiff(bytes).operator bool(); break;
    case 5: read_pclzf_depth(bytes).operator bool(); break;
    case 6: read_pclzf_colour(bytes).operator bool(); break;
    case 7: parse_pcl_camera(bytes).operator bool(); break;
    case 8: parse_camera_file(bytes).operator bool(); break;
    default: read_names(bytes);
  }
  return 0;
}
