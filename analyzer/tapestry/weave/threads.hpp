#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"

namespace vitrine::analyzer {

/// Runs tasks on `threads` threads, the caller's among them. Once all tasks have ended, the caller gets the
/// exception of one that failed.
RunTasks threaded(int threads);

}  // namespace vitrine::analyzer
