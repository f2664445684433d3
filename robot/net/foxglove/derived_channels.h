// Channels of foxglove.* messages that other viewers can draw. They are made only while a client watches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/memory/channel.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/web_socket_out_provider.h"

namespace robot::net {

/// Returns "robot 14/2" for "14/2": the coordinate frame of a robot.
std::string robot_frame(std::string_view robot);

/// Returns "robot 14/2 camera_top" for the topic "/14/2/camera_top" of images: the frame of its camera.
std::string camera_frame(std::string_view topic);

/// Declares `jpeg_quality`, `jpeg_rate_hz` and `jpeg_width`.
void declare_image_parameters(Parameters& parameters);

/// Returns the channels that are derived from `source`, by its schema:
/// of a foresight.Image `<topic>/raw` (foxglove.RawImage) and `<topic>/jpeg` (foxglove.CompressedImage),
/// of a foresight.LogText `<topic>/foxglove` (foxglove.Log). Other channels have none.
/// `parameters` has the parameters of declare_image_parameters(). It is read at each
/// conversion, and outlives the streams.
std::vector<Derived> derived_channels(const memory::ChannelInfo& source, const Parameters& parameters);

}  // namespace robot::net
