#include "tests/support/bhuman2009_writer.h"

#include <cmath>
#include <cstdio>
// jpeglib.h needs stdio.h before it
#include <jpeglib.h>

#include <cstdlib>
#include <vector>

namespace tests {
namespace {

template <class T>
void put(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// A JPEG of the four components Y U Y V, all of one colour.
std::string four_component_jpeg(const Bhuman2009Writer::Cognition& frame) {
  jpeg_compress_struct encoder{};
  jpeg_error_mgr errors;
  encoder.err = jpeg_std_error(&errors);
  jpeg_create_compress(&encoder);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&encoder, &buffer, &size);
  encoder.image_width = frame.width;
  encoder.image_height = frame.height;
  encoder.input_components = 4;
  encoder.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, 95, TRUE);
  jpeg_start_compress(&encoder, TRUE);
  std::vector<unsigned char> row;
  for (std::uint32_t x = 0; x < frame.width; ++x) row.insert(row.end(), {frame.y, frame.u, frame.y, frame.v});
  JSAMPROW rows = row.data();
  while (encoder.next_scanline < encoder.image_height) jpeg_write_scanlines(&encoder, &rows, 1);
  jpeg_finish_compress(&encoder);
  std::string jpeg(reinterpret_cast<char*>(buffer), size);
  jpeg_destroy_compress(&encoder);
  std::free(buffer);
  return jpeg;
}

std::string image_payload(const Bhuman2009Writer::Cognition& frame) {
  const std::string jpeg = four_component_jpeg(frame);
  std::string image;
  for (const std::uint32_t number : {frame.width, frame.height, frame.time_ms, static_cast<std::uint32_t>(jpeg.size())})
    put(image, number);
  return image + jpeg;
}

std::string matrix_payload(const Bhuman2009Writer::Cognition& frame) {
  const double c = std::cos(frame.tilt), s = std::sin(frame.tilt);
  std::string matrix;
  for (const double number : {c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c, 50.0, -10.0, frame.height_mm}) put(matrix, number);
  put<std::uint32_t>(matrix, frame.valid);
  return matrix;
}

std::string coordinates_payload(const Bhuman2009Writer::Cognition& frame) {
  std::string coordinates(112, '\0');
  put(coordinates, frame.width);
  put(coordinates, frame.height);
  for (const double number : {0.78674, 0.60349, 385.54, frame.width / 2.0, frame.height / 2.0})
    put(coordinates, number);
  return coordinates;
}

}  // namespace

void Bhuman2009Writer::message(std::uint8_t id, std::string_view payload) {
  put(messages_, static_cast<std::uint32_t>(payload.size() << 8 | id));
  messages_ += payload;
  ++count_;
}

void Bhuman2009Writer::motion(const Motion& frame) {
  std::string joints, sensors, keys, odometry;
  put(joints, frame.angles);
  put(joints, frame.time_ms);
  put(sensors, frame.sensors);
  put(sensors, frame.milliamperes);
  put(sensors, frame.celsius);
  put(sensors, frame.sonar_pair);
  put(sensors, frame.time_ms);
  put(keys, frame.keys);
  put(odometry, frame.odometry);
  message(1, "m");
  message(5, joints);
  message(7, keys);
  message(6, sensors);
  message(8, odometry);
  message(2, "m");
}

void Bhuman2009Writer::cognition(const Cognition& frame) {
  message(1, "c");
  message(4, image_payload(frame));
  message(17, matrix_payload(frame));
  message(18, coordinates_payload(frame));
  message(2, "c");
}

std::string Bhuman2009Writer::file() const {
  std::string file;
  put(file, static_cast<std::uint32_t>(messages_.size()));
  put(file, count_);
  return file + messages_;
}

}  // namespace tests
