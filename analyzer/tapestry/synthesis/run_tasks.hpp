#pragma once

#include <functional>

namespace vitrine::analyzer {

/// Runs task(0) ... task(count - 1), in any order and on any threads, and returns when all are done. What the
/// tasks give does not depend on it: this folder starts no threads itself, they are passed in.
using RunTasks = std::function<void(int count, const std::function<void(int)>& task)>;

/// One after another.
inline void run_in_order(int count, const std::function<void(int)>& task) {
    for (int i = 0; i < count; ++i)
        task(i);
}

}  // namespace vitrine::analyzer
