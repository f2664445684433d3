// Lanes: the same formula for several robots at once.
//
// A kernel is a function with loops over the lanes of a block. The body of a loop is a formula of floats without
// branches, so the compiler computes four lanes with one instruction, or eight on a processor with AVX2. Each lane gets
// the same bits as the formula alone: nothing is fused or reordered (sim/CMakeLists.txt).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/math/random.h"
#include "sim/math/vec2.h"

/// The head of a loop over the lanes of a block. No lane may read what another one writes.
#if defined(__clang__)
#define SIM_FOR_LANES(i) \
  _Pragma("clang loop vectorize(assume_safety) interleave(disable)") for (int i = 0; i < sim::kLanes; ++i)
#else
#define SIM_FOR_LANES(i) _Pragma("GCC ivdep") for (int i = 0; i < sim::kLanes; ++i)
#endif

namespace sim {

/// Number of lanes of a block.
inline constexpr int kLanes = 8;

/// One value in each lane. The lanes beyond the last robot of a block are copies of it, or keep old
/// values; their results are not read.
template <class T>
struct alignas(sizeof(T) * kLanes) Lane {
  T lane[kLanes];

  constexpr T& operator[](int i) { return lane[i]; }
  constexpr const T& operator[](int i) const { return lane[i]; }
};

/// One vector in each lane.
template <>
struct alignas(sizeof(float) * kLanes) Lane<Vec2> {
  float x[kLanes], y[kLanes];

  constexpr Vec2 operator[](int i) const { return {x[i], y[i]}; }
  constexpr void set(int i, Vec2 value) { x[i] = value.x, y[i] = value.y; }
};

/// Reports whether any lane is not 0. A pass over lanes that nobody needs can be left out.
inline bool any(const Lane<std::int32_t>& lanes) {
  std::int32_t bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= lanes[i];
  return bits != 0;
}

/// The address of a random number in each lane (sim/math/random.h), without its purpose.
struct DrawLanes {
  Lane<std::uint32_t> low, high;  // halves of the key
  Lane<std::uint32_t> robot, number;

  void set(int i, RandomKey key, int of_robot, std::uint32_t with_number) {
    low[i] = static_cast<std::uint32_t>(key.seed), high[i] = static_cast<std::uint32_t>(key.seed >> 32);
    robot[i] = static_cast<std::uint32_t>(of_robot), number[i] = with_number;
  }
  std::array<std::uint32_t, 4> draw(int i, Draw purpose) const {
    return sim::draw({low[i] | static_cast<std::uint64_t>(high[i]) << 32}, robot[i], purpose, number[i]);
  }
};

/// For tests and benches: true limits all kernels to the vectors that each processor of this kind has. Set it while no
/// game is played.
inline bool only_narrow_lanes = false;

namespace detail {

template <auto Kernel, class... Args>
[[gnu::flatten, gnu::noinline]] void run_narrow(Args&... args) {
  Kernel(args...);
}

#if defined(__x86_64__)
template <auto Kernel, class... Args>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void run_wide(Args&... args) {
  Kernel(args...);
}
inline bool has_wide_lanes() { return !only_narrow_lanes && __builtin_cpu_supports("avx2") != 0; }
#else
template <auto Kernel, class... Args>
void run_wide(Args&... args) {
  run_narrow<Kernel>(args...);
}
inline bool has_wide_lanes() { return false; }
#endif

}  // namespace detail

/// Calls Kernel(args...), compiled for the widest vectors of this processor. The result is the same for each width.
template <auto Kernel, class... Args>
void in_lanes(Args&... args) {
  detail::has_wide_lanes() ? detail::run_wide<Kernel>(args...) : detail::run_narrow<Kernel>(args...);
}

/// Computes `all` in parts of at most kLanes items: gather(item, lane) for each item, then compute(), then
/// scatter(item, lane) for each item.
template <class Item, class Gather, class Compute, class Scatter>
void in_blocks(std::span<Item> all, Gather&& gather, Compute&& compute, Scatter&& scatter) {
  for (std::size_t begin = 0; begin < all.size(); begin += kLanes) {
    const std::span<Item> some = all.subspan(begin, std::min<std::size_t>(kLanes, all.size() - begin));
    for (std::size_t i = 0; i < some.size(); ++i) gather(some[i], static_cast<int>(i));
    compute();
    for (std::size_t i = 0; i < some.size(); ++i) scatter(some[i], static_cast<int>(i));
  }
}

}  // namespace sim
