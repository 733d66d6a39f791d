#pragma once

#include "analyzer/network/convolution.hpp"

#include <cstddef>

namespace vitrine::analyzer {

constexpr int lanes = 8;  // values of a vector

using Vector = float __attribute__((vector_size(lanes * sizeof(float))));

/// A function of a kernel: it is compiled into each function that calls it, for the processor of that one.
#define VITRINE_KERNEL [[gnu::always_inline]] inline

/// @param from  lanes values, which need no alignment
VITRINE_KERNEL void load(Vector& to, const float* from) {
    typedef float Stored
        __attribute__((vector_size(lanes * sizeof(float)), aligned(alignof(float)), may_alias));
    to = *reinterpret_cast<const Stored*>(from);
}

/// @param to  lanes values, which need no alignment
VITRINE_KERNEL void store(float* to, const Vector& from) {
    typedef float Stored
        __attribute__((vector_size(lanes * sizeof(float)), aligned(alignof(float)), may_alias));
    *reinterpret_cast<Stored*>(to) = from;
}

VITRINE_KERNEL void activate(Vector& values, Activation activation) {
    if (activation == Activation::none) return;
    const Vector zero{};
    if (activation == Activation::rectified) {
        values = values > zero ? values : zero;
        return;
    }
    Vector share = values * (1.F / 6) + 0.5F;
    share = share > zero ? share : zero;
    share = share < 1.F ? share : zero + 1.F;
    values *= share;
}

/// The size of an array.
constexpr std::size_t product(int a, int b, int c = 1) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c);
}

/// True if the processor computes eight values at once, and that is not turned off.
bool has_wide_vectors();

/// Tests turn wide vectors off, and on again.
void turn_wide_vectors(bool on);

#ifdef __x86_64__
template <auto kernel, typename Task> [[gnu::target("avx2,fma")]] void run_widely(const Task& task) {
    kernel(task);
}
#endif

/// Runs a kernel as the processor does it best.
template <auto kernel, typename Task> void run_kernel(const Task& task) {
#ifdef __x86_64__
    if (has_wide_vectors()) return run_widely<kernel>(task);
#endif
    kernel(task);
}

}  // namespace vitrine::analyzer
