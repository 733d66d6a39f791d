#include "analyzer/network/vectors.hpp"

#include <atomic>

namespace vitrine::analyzer {
namespace {

bool can_compute_widely() {
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") > 0 && __builtin_cpu_supports("fma") > 0;
#else
    return false;
#endif
}

std::atomic<bool>& is_wide() {
    static std::atomic<bool> on = can_compute_widely();
    return on;
}

}  // namespace

bool has_wide_vectors() {
    return is_wide();
}

void turn_wide_vectors(bool on) {
    is_wide() = on && can_compute_widely();
}

}  // namespace vitrine::analyzer
