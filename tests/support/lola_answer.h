// Reads LoLA's actuator frames, by another project's MessagePack reader.
#pragma once

#include <optional>
#include <string>

#include "robot/nao/lola/actuators.h"

namespace tests {

/// Returns positions, stiffness, the chest's and the left eye's colour, or nothing if the bytes are no answer.
std::optional<robot::nao::Actuators> read_answer(const std::string& bytes);

}  // namespace tests
