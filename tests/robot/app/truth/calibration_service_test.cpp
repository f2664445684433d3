#include "robot/app/truth/calibration_service.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "tests/robot/app/truth/watching.h"
#include "tests/support/eventually.h"

namespace robot::app {
namespace {

using nlohmann::json;

/// The services of one watched sensor.
class CalibrationService : public Watching {
 protected:
  /// Begins to watch images, and waits for the first one.
  void serve(std::deque<GivenSource::Answer> answers) {
    watch(std::move(answers));
    add_calibration_services(services, {}, watches, calibrations);
    ASSERT_TRUE(tests::eventually([&] { return is_watching(); }));
  }

  json learn(const json& request = {{"sensor", 1}}) const {
    for (const auto& service : services.list())
      if (service.name == "/truth/background")
        return json::parse(services.call(service.id, request.dump(), {.loopback = true, .may_control = true}));
    return {};
  }

  net::Services services;
};

TEST_F(CalibrationService, TheEmptyFieldIsLearnedFrom15Images) {
  serve(images_from(clock.now_ns(), 2000));
  EXPECT_EQ(learn(), (json{{"ok", true}, {"images", 15}}));
  EXPECT_TRUE(tests::eventually([&] { return told().background_images() == 15; }));
}

TEST_F(CalibrationService, TheEmptyFieldIsNotLearnedWithoutACalibration) {
  calibrated = false;
  serve(images_from(clock.now_ns(), 2000));
  const json answer = learn();
  EXPECT_EQ(answer["ok"], false);
  EXPECT_EQ(answer["error"], "/truth/background: sensor 1 is not calibrated, so it cannot learn the empty field");
}

TEST_F(CalibrationService, TheEmptyFieldIsNotLearnedByAnOrdinaryCamera) {
  auto images = images_from(clock.now_ns(), 2000);
  for (auto& image : images) (*image)->depth.clear();
  serve(std::move(images));
  EXPECT_EQ(learn()["error"],
            "/truth/background: sensor 1 is an ordinary camera without depths, so it cannot learn the empty field");
}

TEST_F(CalibrationService, TheEmptyFieldIsNotLearnedWithoutImages) {
  serve(images_from(clock.now_ns(), 20));
  ASSERT_TRUE(tests::eventually([&] { return has_ended(); }));
  EXPECT_EQ(learn()["error"], "/truth/background: sensor 1 sends no images now, so it cannot learn the empty field");
}

TEST_F(CalibrationService, ASensorThatDoesNotExistIsRefused) {
  serve(images_from(clock.now_ns(), 2000));
  for (const json& request : {json::object(), json{{"sensor", 0}}, json{{"sensor", 2}}, json{{"sensor", "1"}}})
    EXPECT_EQ(learn(request)["error"], "/truth/background: 'sensor' must be a whole number from 1 to 1");
}

}  // namespace
}  // namespace robot::app
