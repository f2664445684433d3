// A small feed-forward net. It gives the same bits on every machine: each sum adds its terms in the order of the inputs,
// and the activations use sim/math.
#pragma once

#include <cstdint>
#include <vector>

namespace sim::agent {

inline constexpr int kMaxWidth = 512;  // inputs or outputs of a layer
inline constexpr int kMaxLayers = 8;

/// The function of a layer's sums.
enum class Activation : std::uint8_t { none, relu, tanh };
inline constexpr const char* kActivations[] = {"none", "relu", "tanh"};  // by Activation

/// One layer: activation(bias + weights * inputs).
struct Layer {
  int inputs = 0;
  int outputs = 0;
  std::vector<float> weights;  // inputs x outputs: the weights of the first input, then of the second, …
  std::vector<float> bias;     // by output
  Activation activation = Activation::none;
};

/// A net. The outputs of a layer are as many as the inputs of the next.
struct Net {
  std::vector<Layer> layers;

  int inputs() const { return layers.front().inputs; }
  int outputs() const { return layers.back().outputs; }
};

/// Computes the outputs. Allocates nothing. `outputs` has room for kMaxWidth numbers.
void evaluate(const Net& net, const float* inputs, float* outputs);

/// Returns the number of the largest output, the first of equal ones. A NaN is never the largest.
int largest(const float* outputs, int count);

}  // namespace sim::agent
