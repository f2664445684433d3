// A frame of LoLA is read as it was sent, with its keys in any order. Other bytes are refused with a sentence.
#include "robot/nao/lola/sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "tests/support/lola_frame.h"
#include "tests/support/real_data.h"

namespace robot::nao {
namespace {

using tests::LolaFrame;

Sensors random_sensors(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-3, 3);
  Sensors sensors;
  sensors.visit([&](std::string_view key, auto& numbers) {
    for (float& value : numbers) value = key == "Status" ? static_cast<float>(random() % 100) : number(random);
  });
  return sensors;
}

/// Returns all numbers in the order of visit().
std::vector<float> numbers_of(Sensors sensors) {
  std::vector<float> all;
  sensors.visit([&](std::string_view, const auto& numbers) { all.insert(all.end(), numbers.begin(), numbers.end()); });
  return all;
}

/// Returns `frame` without the key `left_out`, with its other keys in another order.
std::string reordered(Sensors sensors, std::string_view left_out = "") {
  LolaFrame frame;
  sensors.visit([&](std::string_view key, const auto& numbers) {
    if (key != left_out) frame.floats(key, {numbers.begin(), numbers.end()});
  });
  if (left_out != "RobotConfig") frame.identity();
  return frame.frame();
}

std::string why_not(std::string_view frame) {
  Sensors sensors;
  const Result<void> read = SensorFrames().read(frame, sensors);
  return read ? "read" : read.error();
}

TEST(LolaSensors, AreReadAsTheyWereSent) {
  SensorFrames frames;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Sensors sent = random_sensors(seed);
    const std::string frame = tests::lola_frame(sent);
    EXPECT_EQ(frame.size(), 896u);
    EXPECT_EQ(*frames.size_of_first(frame + "the next one"), frame.size());
    Sensors got;
    const Result<void> read = frames.read(frame, got);
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(numbers_of(got), numbers_of(sent));
  }
  EXPECT_EQ(frames.identity().body_id, "P0000073A03S83I00011");
  EXPECT_EQ(frames.identity().head_version, "6.0.0");
}

TEST(LolaSensors, AreParsedAgainWhenTheLayoutChanges) {
  SensorFrames frames;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Sensors sent = random_sensors(seed), got;
    const std::string frame = seed % 2 ? reordered(sent) : tests::lola_frame(sent);
    EXPECT_EQ(*frames.size_of_first(frame), frame.size());
    ASSERT_TRUE(frames.read(frame, got));
    EXPECT_EQ(numbers_of(got), numbers_of(sent));
  }
}

TEST(LolaSensors, AreReadInEveryEncodingOfNumbers) {
  Sensors sent = random_sensors(1), got;
  sent.battery = {1, -32552, 200, 3.5f};
  LolaFrame frame;
  frame.identity();
  sent.visit([&](std::string_view key, const auto& numbers) {
    if (key != "Battery") frame.floats(key, {numbers.begin(), numbers.end()});
  });
  using namespace std::string_literals;
  const auto battery = [&](const std::string& written) {
    LolaFrame whole = frame;
    return whole.key("Battery").array(4).bytes(written).frame();
  };
  SensorFrames frames;
  // one byte, two signed bytes, one unsigned, a double
  ASSERT_TRUE(frames.read(battery("\x01\xd1\x80\xd8\xcc\xc8\xcb\x40\x0c\0\0\0\0\0\0"s), got));
  EXPECT_EQ(got.battery, sent.battery);
  // a negative number in its marker, four and eight unsigned bytes, eight signed
  ASSERT_TRUE(frames.read(battery("\xff\xce\0\0\1\0\xcf\0\0\0\0\0\0\0\7\xd3\xff\xff\xff\xff\xff\xff\xff\xfe"s), got));
  EXPECT_EQ(got.battery, (std::array<float, 4>{-1, 256, 7, -2}));
  ASSERT_TRUE(frames.read(battery("\xe0\xcd\1\0\xd0\x80\xd2\xff\xff\xff\xfd"s), got));
  EXPECT_EQ(got.battery, (std::array<float, 4>{-32, 256, -128, -3}));
  // the same layout with other values
  ASSERT_TRUE(frames.read(battery("\xe1\xcd\1\1\xd0\x81\xd2\xff\xff\xff\xfc"s), got));
  EXPECT_EQ(got.battery, (std::array<float, 4>{-31, 257, -127, -4}));
}

TEST(LolaSensors, SkipUnknownKeys) {
  using namespace std::string_literals;
  LolaFrame frame;
  frame.key("New").bytes("\x82\xa1x\x92\xc0\xc3\xa1y\xc4\x02\1\2"s).key("Newer").bytes("\xd6\1\1\2\3\4"s);
  frame.key("Newest").bytes("\xc7\x02\5\1\2"s).key("Other").bytes("\xdf\0\0\0\1\xd9\1z\xdd\0\0\0\0"s);
  Sensors sent = random_sensors(2), got;
  sent.visit([&](std::string_view key, const auto& numbers) {
    // a map of more than 15 pairs needs another header, which replaces the first byte below
    if (key != "Sonar") frame.floats(key, {numbers.begin(), numbers.end()});
  });
  frame.floats("Sonar", {0.5f, 0.6f}).identity();
  const std::string keys = frame.frame();
  const std::string whole = "\xde\0\x11"s + keys.substr(1);
  ASSERT_EQ(why_not(whole), "read");
  ASSERT_TRUE(SensorFrames().read(whole, got));
  EXPECT_EQ(got.position, sent.position);
  EXPECT_EQ(got.sonar, (std::array<float, 2>{0.5f, 0.6f}));
}

TEST(LolaSensors, SurviveEveryTruncation) {
  const std::string frame = tests::lola_frame(random_sensors(3));
  for (std::size_t bytes = 0; bytes < frame.size(); ++bytes) {
    const std::string_view part = std::string_view(frame).substr(0, bytes);
    SensorFrames frames;
    const Result<std::size_t> size = frames.size_of_first(part);
    ASSERT_TRUE(size) << bytes;
    EXPECT_EQ(*size, 0u) << "more bytes are needed after " << bytes;
    Sensors sensors;
    EXPECT_FALSE(frames.read(part, sensors)) << bytes;
  }
}

TEST(LolaSensors, SurviveEveryChangedByte) {
  const Sensors sent = random_sensors(4);
  const std::string frame = tests::lola_frame(sent);
  std::mt19937 random(4);
  SensorFrames frames;
  Sensors sensors;
  ASSERT_TRUE(frames.read(frame, sensors));
  for (std::size_t at = 0; at < frame.size(); ++at)
    for (int i = 0; i < 8; ++i) {
      std::string damaged = frame;
      damaged[at] = static_cast<char>(random());
      sensors = {};
      // a reader that has seen other frames returns the same as a new reader, also for damaged frames
      SensorFrames fresh;
      Sensors by_fresh;
      const bool read = static_cast<bool>(frames.read(damaged, sensors));
      ASSERT_EQ(read, static_cast<bool>(fresh.read(damaged, by_fresh))) << at;
      EXPECT_EQ(numbers_of(sensors), numbers_of(by_fresh)) << at;
      static_cast<void>(frames.size_of_first(damaged));
    }
}

TEST(LolaSensors, NameTheMissingValue) {
  for (const char* key : {"Position", "Stiffness", "Temperature", "Current", "Status", "Accelerometer", "Gyroscope",
                          "Angles", "Battery", "FSR", "Sonar", "Touch", "RobotConfig"})
    EXPECT_EQ(why_not(reordered(random_sensors(5), key)),
              "LoLA: " + std::string(key) + ": expected it in every frame, got a frame without it");
}

TEST(LolaSensors, NameTheWrongValue) {
  EXPECT_EQ(why_not(LolaFrame().floats("Position", {1, 2, 3}).frame()), "LoLA: Position: expected 25 numbers, got 3");
  EXPECT_EQ(why_not(LolaFrame().floats("FSR", std::vector<float>(500)).frame()),
            "LoLA: FSR: expected 8 numbers, got 500");
  EXPECT_EQ(why_not(LolaFrame().key("Angles").array(2).text("up").text("down").frame()),
            "LoLA: Angles: expected numbers, got something else");
  EXPECT_EQ(why_not(LolaFrame().floats("Sonar", {1, 2}).floats("Sonar", {1, 2}).frame()),
            "LoLA: Sonar: expected it once, got it again");
  EXPECT_EQ(why_not(LolaFrame().key("RobotConfig").array(1).text("P1").frame()),
            "LoLA: RobotConfig: expected 4 texts, got 1");
  const std::string frame = tests::lola_frame(random_sensors(6));
  EXPECT_EQ(why_not(frame + "x"), "LoLA: expected one whole frame, got 897 bytes that cannot be parsed as one");
  EXPECT_EQ(why_not("HTTP/1.1 400 Bad Request"),
            "LoLA: expected one whole frame, got 24 bytes that cannot be parsed as one");
  EXPECT_EQ(why_not(std::string(5000, '\x80')), "LoLA: expected a frame of at most 4096 bytes, got 5000");
  Sensors sensors = random_sensors(7);
  sensors.gyroscope[1] = std::nanf("");
  EXPECT_EQ(why_not(tests::lola_frame(sensors)), "LoLA: Gyroscope: expected finite numbers, got one that is not");
}

TEST(LolaSensors, RefuseBytesThatAreNoFrame) {
  const SensorFrames frames;
  EXPECT_EQ(frames.size_of_first("HTTP/1.1").error(),
            "LoLA: expected a MessagePack map with texts as keys, got something else");
  // a text with a huge length, a map with a huge count, endlessly nested arrays
  using namespace std::string_literals;
  EXPECT_FALSE(frames.size_of_first("\x81\xdb\xff\xff\xff\xff"s));
  EXPECT_EQ(*frames.size_of_first("\xdf\xff\xff\xff\xff"s), 0u);
  EXPECT_FALSE(frames.size_of_first("\x81\xa1x"s + std::string(100, '\x91')));
  // a frame that does not end
  std::string endless = "\xdf\xff\xff\xff\xff"s;
  while (endless.size() < SensorFrames::kMaxBytes) endless += "\xa1x\xa1y";
  EXPECT_EQ(frames.size_of_first(endless).error(), "LoLA: expected a frame of at most 4096 bytes, got a longer one");
}

TEST(LolaSensors, KeepTheOldOnesAfterAnError) {
  SensorFrames frames;
  Sensors sensors;
  ASSERT_TRUE(frames.read(tests::lola_frame(random_sensors(8)), sensors));
  ASSERT_FALSE(frames.read("nonsense", sensors));
  EXPECT_EQ(numbers_of(sensors), numbers_of(random_sensors(8)));
  ASSERT_TRUE(frames.read(tests::lola_frame(random_sensors(9)), sensors)) << "and go on with the next frame";
  EXPECT_EQ(numbers_of(sensors), numbers_of(random_sensors(9)));
}

TEST(LolaSensors, OfARealRobotEqualItsOwnersValues) {
  REAL_DATA_OR_SKIP(path, "lola/lola_sensor_dump_berlin_united.msgpack");
  const auto frame = read_file(path, SensorFrames::kMaxBytes);
  SensorFrames frames;
  Sensors sensors;
  ASSERT_TRUE(frames.read(*frame, sensors));
  EXPECT_EQ(frames.identity().head_id, "P0000074A03S84F00006");

  std::ifstream text(std::filesystem::path(path).replace_extension("json"));
  const nlohmann::json expected = nlohmann::json::parse(text);
  sensors.visit([&](std::string_view key, const auto& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      EXPECT_EQ(numbers[i], expected[std::string(key)][i].get<float>()) << key << " " << i;
  });
}

TEST(LolaSensors, OfAnotherSourceAreFrames) {
  REAL_DATA_OR_SKIP(path, "lola/lola_sensor_nao_lola_test_values.msgpack");
  EXPECT_EQ(why_not(*read_file(path, SensorFrames::kMaxBytes)), "read");
}

}  // namespace
}  // namespace robot::nao
