#include "sim/io/policy.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "robot/core/json_library.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"
#include "sim/io/vocabulary.h"
#include "sim/io/words.h"

namespace sim::io {

using robot::Error;
using robot::Result;

namespace {

constexpr float kLargestWeight = 1e6f;

/// Reads the features of "inputs".
std::vector<agent::Feature> read_inputs(Reader& reader, const Json& policy) {
  const auto inputs = policy.find("inputs");
  if (inputs == policy.end()) return agent::built_in_features();
  std::vector<agent::Feature> features;
  if (!inputs->is_array() || inputs->empty()) {
    reader.refuse("inputs must be a list of features, got " + shown(*inputs));
    return features;
  }
  for (std::size_t i = 0; i < inputs->size() && reader.good(); ++i) {
    const Json& name = (*inputs)[i];
    const std::string path = "inputs[" + std::to_string(i) + "]";
    if (!name.is_string()) {
      reader.refuse(path + " must be the name of a feature, got " + shown(name));
      break;
    }
    const Result<agent::Feature> feature = feature_named(name.get_ref<const std::string&>());
    if (!feature)
      reader.refuse(path + ": " + feature.error());
    else if (std::ranges::find(features, *feature) != features.end())
      reader.refuse(path + " names " + shown(name) + " twice");
    else
      features.push_back(*feature);
  }
  return features;
}

/// Appends `count` numbers from a list.
void read_numbers(Reader& reader, const Json& list, const std::string& path, int count, std::vector<float>& into) {
  if (!list.is_array() || list.size() != static_cast<std::size_t>(count))
    return reader.refuse(path + " must be a list of " + std::to_string(count) + " numbers, got " +
                         (list.is_array() ? "one of " + std::to_string(list.size()) : shown(list)));
  for (const Json& number : list) {
    const double value = number.is_number() ? number.get<double>() : NAN;
    if (!(std::abs(value) <= static_cast<double>(kLargestWeight)))
      return reader.refuse(path + " must have numbers from -1e6 to 1e6, got " + shown(number));
    into.push_back(static_cast<float>(value));
  }
}

agent::Activation read_activation(Reader& reader, const Json& layer, const std::string& path) {
  const Json* name = reader.find(layer, "activation", Fields::some);
  if (!name) return agent::Activation::none;
  for (std::size_t i = 0; i < std::size(agent::kActivations); ++i)
    if (*name == agent::kActivations[i]) return static_cast<agent::Activation>(i);
  reader.refuse(path + ".activation must be one of none, relu, tanh, got " + shown(*name));
  return agent::Activation::none;
}

/// Reads a layer with that number of inputs.
agent::Layer read_layer(Reader& reader, const Json& json, const std::string& path, int inputs) {
  agent::Layer layer{.inputs = inputs};
  if (!reader.is_object(json, path)) return layer;
  reader.refuse_unknown(json, path, {"weights", "bias", "activation"});
  const auto rows = json.find("weights"), bias = json.find("bias");
  if (rows == json.end() || bias == json.end()) {
    reader.refuse(path + " must have weights and bias");
    return layer;
  }
  if (!rows->is_array() || rows->empty() || rows->size() > agent::kMaxWidth) {
    reader.refuse(path + ".weights must have 1 .. " + std::to_string(agent::kMaxWidth) + " rows, one per output");
    return layer;
  }
  layer.outputs = static_cast<int>(rows->size());
  read_numbers(reader, *bias, path + ".bias", layer.outputs, layer.bias);
  layer.activation = read_activation(reader, json, path);
  // a row has the weights of one output; a layer has those of one input in a row
  std::vector<float> by_output;
  for (std::size_t i = 0; i < rows->size() && reader.good(); ++i)
    read_numbers(reader, (*rows)[i], path + ".weights[" + std::to_string(i) + "]", inputs, by_output);
  if (!reader.good()) return layer;
  const auto width = static_cast<std::size_t>(inputs), count = rows->size();
  layer.weights.resize(by_output.size());
  for (std::size_t o = 0; o < count; ++o)
    for (std::size_t i = 0; i < width; ++i) layer.weights[i * count + o] = by_output[o * width + i];
  return layer;
}

agent::Net read_net(Reader& reader, const Json& policy, const agent::Frame& frame) {
  agent::Net net;
  const auto found = policy.find("net");
  if (found == policy.end()) {
    reader.refuse("net is missing");
    return net;
  }
  if (!reader.is_object(*found, "net")) return net;
  reader.refuse_unknown(*found, "net", {"layers"});
  const auto layers = found->find("layers");
  if (layers == found->end() || !layers->is_array() || layers->empty() || layers->size() > agent::kMaxLayers) {
    reader.refuse("net.layers must be a list of 1 .. " + std::to_string(agent::kMaxLayers) + " layers");
    return net;
  }
  int width = frame.columns.count();
  for (std::size_t i = 0; i < layers->size() && reader.good(); ++i) {
    net.layers.push_back(read_layer(reader, (*layers)[i], "net.layers[" + std::to_string(i) + "]", width));
    width = net.layers.back().outputs;
  }
  if (reader.good() && width != static_cast<int>(frame.tree.menu.size()))
    reader.refuse("the last layer must have " + std::to_string(frame.tree.menu.size()) +
                  " outputs, one per rule of the menu, got " + std::to_string(width));
  return net;
}

}  // namespace

Result<agent::Frame> read_frame(const Json& policy, const std::string& called) {
  Json strategy = policy;
  for (const char* key : {"inputs", "net"}) strategy.erase(key);
  Result<agent::Tree> tree = parse_menu(strategy, called);
  if (!tree) return tree.failure();
  Reader reader(called);
  agent::Frame frame{.tree = *std::move(tree), .columns = agent::Columns(read_inputs(reader, policy))};
  if (frame.columns.count() > agent::kMaxColumns)
    reader.refuse("inputs must have at most " + std::to_string(agent::kMaxColumns) + " columns, got " +
                  std::to_string(frame.columns.count()));
  if (!reader.good()) return reader.error();
  return frame;
}

Result<agent::PolicyBehaviour> parse_policy(std::string_view text, const std::string& called) {
  if (text.size() > kMaxFileBytes)
    return Error{called + ": must have at most " + std::to_string(kMaxFileBytes) + " bytes, got " +
                 std::to_string(text.size())};
  const Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  Result<agent::Frame> frame = read_frame(*json, called);
  if (!frame) return frame.failure();
  Reader reader(called);
  agent::Net net = read_net(reader, *json, *frame);
  if (!reader.good()) return reader.error();
  return agent::PolicyBehaviour(*std::move(frame), std::move(net));
}

}  // namespace sim::io
