#pragma once

#include "analyzer/network/convolution.hpp"

#include <cstddef>

namespace vitrine::analyzer {

constexpr int max_lanes = 8;  // values of the widest vector

template <int lanes> struct VectorOf {
    typedef float Type __attribute__((vector_size(lanes * sizeof(float))));
    typedef float Stored
        __attribute__((vector_size(lanes * sizeof(float)), aligned(alignof(float)), may_alias));
};

/// So many values, which the processor computes at once. GCC computes those of a vector that is wider than
/// the registers one by one, ten times as slowly.
template <int lanes> using Vector = typename VectorOf<lanes>::Type;

/// A function of a kernel: it is compiled into each function that calls it, for the processor of that one.
#define VITRINE_KERNEL [[gnu::always_inline]] inline

/// @param from  needs no alignment
template <int lanes> VITRINE_KERNEL void load(Vector<lanes>& to, const float* from) {
    to = *reinterpret_cast<const typename VectorOf<lanes>::Stored*>(from);
}

/// @param to  needs no alignment
template <int lanes> VITRINE_KERNEL void store(float* to, const Vector<lanes>& from) {
    *reinterpret_cast<typename VectorOf<lanes>::Stored*>(to) = from;
}

template <int lanes> VITRINE_KERNEL void activate(Vector<lanes>& values, Activation activation) {
    if (activation == Activation::none) return;
    const Vector<lanes> zero{};
    if (activation == Activation::rectified) {
        values = values > zero ? values : zero;
        return;
    }
    Vector<lanes> share = values * (1.F / 6) + 0.5F;
    share = share > zero ? share : zero;
    share = share < 1.F ? share : zero + 1.F;
    values *= share;
}

/// The size of an array.
constexpr std::size_t product(int a, int b, int c = 1) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c);
}

/// True if the processor computes eight values at once, and that is not turned off. All compute four.
bool has_wide_vectors();

/// Tests turn wide vectors off, and on again.
void turn_wide_vectors(bool on);

#ifdef __x86_64__
template <typename Kernel, typename Task> [[gnu::target("avx2,fma")]] void run_widely(const Task& task) {
    Kernel::template run<8>(task);
}
#endif

/// Runs a kernel with as many values at once as the processor computes.
template <typename Kernel, typename Task> void run_kernel(const Task& task) {
#ifdef __x86_64__
    if (has_wide_vectors()) return run_widely<Kernel>(task);
#endif
    Kernel::template run<4>(task);
}

}  // namespace vitrine::analyzer
