// Lanes: the same formula for several robots at once.
//
// A kernel is a function with loops over the lanes of a block. The body of a loop is a formula of floats without
// branches, so the compiler computes four lanes with one instruction, or eight on a processor with AVX2. Each lane gets
// the same bits as the formula alone: nothing is fused or reordered (sim/CMakeLists.txt).
#pragma once

#include <cstdint>

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

/// One value in each lane.
template <class T>
struct alignas(sizeof(T) * kLanes) Lane {
  T lane[kLanes];

  constexpr T& operator[](int i) { return lane[i]; }
  constexpr const T& operator[](int i) const { return lane[i]; }
};

namespace detail {

template <auto kernel, class... Args>
[[gnu::flatten, gnu::noinline]] void run_narrow(Args&... args) {
  kernel(args...);
}

#if defined(__x86_64__)
template <auto kernel, class... Args>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void run_wide(Args&... args) {
  kernel(args...);
}
inline bool has_wide_lanes() { return __builtin_cpu_supports("avx2") != 0; }
#else
template <auto kernel, class... Args>
void run_wide(Args&... args) {
  run_narrow<kernel>(args...);
}
inline bool has_wide_lanes() { return false; }
#endif

}  // namespace detail

/// Calls kernel(args...), compiled for the widest vectors of this processor. The result is the same for each width.
template <auto kernel, class... Args>
void in_lanes(Args&... args) {
  detail::has_wide_lanes() ? detail::run_wide<kernel>(args...) : detail::run_narrow<kernel>(args...);
}

}  // namespace sim
