// The robot's whole cognitive state: the table of contents of the robot.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "proto/foresight/agent.pb.h"
#include "proto/foresight/ball.pb.h"
#include "proto/foresight/camera.pb.h"
#include "proto/foresight/forecast.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/opponents.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foresight/sensors.pb.h"
#include "proto/foresight/sim.pb.h"
#include "proto/foresight/strategy.pb.h"
#include "proto/foresight/team.pb.h"
#include "proto/foresight/truth.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory_object.h"

namespace robot::memory {

namespace pb = foresight;

/// All data that the robot's threads exchange.
/// The .proto of each message documents its writer, rate, frame and units.
///
/// A new object needs one .proto, one member and one `see` line. Logs, streams and the viewer then know it.
struct Memory {
  MemoryObject<pb::Image> camera_top;
  MemoryObject<pb::Image> camera_bottom;
  MemoryObject<pb::CameraMatrix> camera_top_matrix;
  MemoryObject<pb::CameraMatrix> camera_bottom_matrix;
  MemoryObject<pb::Joints> joints;
  MemoryObject<pb::Inertial> inertial;
  MemoryObject<pb::Fsr> fsr;
  MemoryObject<pb::Sonar> sonar;
  MemoryObject<pb::Touch> touch;
  MemoryObject<pb::Battery> battery;
  MemoryObject<pb::Body> body;
  MemoryObject<pb::Odometry> odometry;
  MemoryObject<pb::Vision> vision;
  MemoryObject<pb::Ball> ball;
  MemoryObject<pb::Pose> pose;
  MemoryObject<pb::Team> team;
  MemoryObject<pb::Opponents> opponents;
  MemoryObject<pb::GameState> game;
  MemoryObject<pb::MotionCommand> motion_command;
  MemoryObject<pb::MotionStatus> motion_status;
  MemoryObject<pb::DecisionTrace> decision;
  MemoryObject<pb::WhatIf> what_if;
  MemoryObject<pb::Forecast> forecast;
  MemoryObject<pb::Strategy> strategy;
  MemoryObject<pb::ForecastScore> forecast_score;
  MemoryObject<pb::ClockSample> clock;
  MemoryObject<pb::RuntimeStatistics> runtime;
  MemoryObject<pb::LogText> log;
  MemoryObject<pb::GroundTruth> truth;
  MemoryObject<pb::Simulation> simulation;

  /// Calls see(name, object, delivery) for each object. A name that starts with '/' is the whole topic;
  /// any other name belongs to this robot: "/<robot>/<name>".
  template <class Visitor>
  void visit(Visitor&& see) {
    using enum Delivery;
    see("camera_top", camera_top, latest);
    see("camera_bottom", camera_bottom, latest);
    see("camera_top_matrix", camera_top_matrix, latest);
    see("camera_bottom_matrix", camera_bottom_matrix, latest);
    see("joints", joints, fifo);
    see("inertial", inertial, fifo);
    see("fsr", fsr, fifo);
    see("sonar", sonar, fifo);
    see("touch", touch, fifo);
    see("battery", battery, latest);
    see("body", body, reliable);
    see("odometry", odometry, fifo);
    see("vision", vision, latest);
    see("ball", ball, latest);
    see("pose", pose, latest);
    see("team", team, latest);
    see("opponents", opponents, latest);
    see("game", game, reliable);
    see("motion_command", motion_command, fifo);
    see("motion_status", motion_status, fifo);
    see("decision", decision, fifo);
    see("what_if", what_if, reliable);
    see("forecast", forecast, reliable);
    see("strategy", strategy, reliable);
    see("forecast_score", forecast_score, latest);
    see("clock", clock, reliable);
    see("runtime", runtime, latest);
    see("log", log, reliable);
    see("/truth/world", truth, latest);
    see("/sim/state", simulation, latest);
  }

  /// Makes the memory of `robot`, "<team>/<player>". `clock` is its time base and outlives it.
  Memory(std::string_view robot, const Clock& clock);
  /// Not inline: otherwise every file that includes this header compiles all memory
  /// objects, 2 s of processor time each.
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
};

/// Adds every object of `memory` to `channels`, which then keeps the memory alive.
/// Returns an Error if a topic is in the list already, for instance from a second memory of the same robot.
Result<void> list(const std::shared_ptr<Memory>& memory, Channels& channels);

}  // namespace robot::memory
