#include "sim/agent/net.h"

#include <algorithm>

#include "sim/math/angles.h"

namespace sim::agent {
namespace {

void activate(Activation activation, float* values, int count) {
  if (activation == Activation::relu)
    for (int i = 0; i < count; ++i) values[i] = values[i] > 0 ? values[i] : 0;
  if (activation == Activation::tanh)
    for (int i = 0; i < count; ++i) values[i] = 1 - 2 / (exp(2 * values[i]) + 1);
}

/// Input by input, so that the compiler computes several outputs at once and each sum keeps its order.
void evaluate(const Layer& layer, const float* inputs, float* outputs) {
  std::copy(layer.bias.begin(), layer.bias.end(), outputs);
  const float* weights = layer.weights.data();
  for (int i = 0; i < layer.inputs; ++i)
    for (int o = 0; o < layer.outputs; ++o) outputs[o] += *weights++ * inputs[i];
  activate(layer.activation, outputs, layer.outputs);
}

}  // namespace

void evaluate(const Net& net, const float* inputs, float* outputs) {
  float between[2][kMaxWidth];
  const float* in = inputs;
  for (std::size_t i = 0; i < net.layers.size(); ++i) {
    float* const out = i + 1 == net.layers.size() ? outputs : between[i % 2];
    evaluate(net.layers[i], in, out);
    in = out;
  }
}

int largest(const float* outputs, int count) {
  int best = 0;
  for (int i = 1; i < count; ++i)
    if (outputs[i] > outputs[best] || outputs[best] != outputs[best]) best = i;
  return best;
}

}  // namespace sim::agent
