#include "sim/agent/net.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "sim/math/random.h"
#include "tests/sim/support/allocations.h"

namespace sim::agent {
namespace {

float number(std::uint32_t address) { return 2 * uniform(draw({9}, kNobody, Draw::situation, address)[0]) - 1; }

/// A net of random weights with these widths. The last layer has no activation.
Net net_of(const std::vector<int>& widths, Activation activation) {
  Net net;
  std::uint32_t address = 0;
  for (std::size_t i = 0; i + 1 < widths.size(); ++i) {
    Layer layer{.inputs = widths[i],
                .outputs = widths[i + 1],
                .activation = i + 2 == widths.size() ? Activation::none : activation};
    for (int w = 0; w < layer.inputs * layer.outputs; ++w) layer.weights.push_back(number(address++));
    for (int b = 0; b < layer.outputs; ++b) layer.bias.push_back(number(address++));
    net.layers.push_back(layer);
  }
  return net;
}

std::vector<float> outputs_of(const Net& net, std::uint32_t row) {
  float inputs[kMaxWidth], outputs[kMaxWidth];
  for (int i = 0; i < net.inputs(); ++i) inputs[i] = number(1'000'000 + 1000 * row + static_cast<std::uint32_t>(i));
  evaluate(net, inputs, outputs);
  return {outputs, outputs + net.outputs()};
}

TEST(Net, IsActivationOfBiasAndWeightedInputs) {
  const Net net{
      {Layer{2, 2, {1, 3, 2, -4}, {0.5f, -1}, Activation::relu}, Layer{2, 1, {2, 10}, {1}, Activation::none}}};
  const float inputs[] = {1, 2};
  float outputs[kMaxWidth];
  evaluate(net, inputs, outputs);
  // hidden: 0.5 + 1 + 4 = 5.5 and -1 + 3 - 8 = -6, which relu makes 0
  EXPECT_EQ(outputs[0], 12);
}

TEST(Net, TanhIsThatOfTheLibraryButForRounding) {
  for (float x = -20; x < 20; x += 0.01f) {
    const Net net{{Layer{1, 1, {1}, {0}, Activation::tanh}}};
    float output[kMaxWidth];
    evaluate(net, &x, output);
    ASSERT_NEAR(output[0], std::tanh(x), 3e-7f) << x;
  }
}

TEST(Net, GivesTheSameBitsOnEveryMachine) {
  std::uint32_t sum = 0;
  for (const Activation activation : {Activation::tanh, Activation::relu}) {
    const Net net = net_of({37, 64, 33, 12}, activation);
    for (std::uint32_t row = 0; row < 100; ++row)
      for (const float value : outputs_of(net, row)) sum = 31 * sum + std::bit_cast<std::uint32_t>(value);
  }
  EXPECT_EQ(sum, 39401242u);
}

TEST(Net, AllocatesNothing) {
  const Net net = net_of({8, 16, 4}, Activation::tanh);
  const float inputs[8] = {};
  float outputs[kMaxWidth];
  const std::size_t before = test::allocations();
  evaluate(net, inputs, outputs);
  EXPECT_EQ(test::allocations(), before);
}

TEST(Net, TheLargestIsTheFirstOfEqualOnesAndNeverNan) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float equal[] = {1, 3, 3}, first[] = {nan, -2, -3}, later[] = {1, nan, 2};
  EXPECT_EQ(largest(equal, 3), 1);
  EXPECT_EQ(largest(first, 3), 1);
  EXPECT_EQ(largest(later, 3), 2);
}

}  // namespace
}  // namespace sim::agent
