#include "analyzer/tapestry/weave/threads.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vitrine::analyzer {

RunTasks threaded(int threads) {
    if (threads <= 1) return run_in_order;
    return [threads](int count, const std::function<void(int)>& task) {
        std::atomic<int> next{0};
        std::mutex mutex;
        std::exception_ptr failure;  // guarded by mutex
        const auto work = [&] {
            try {
                for (int i = next++; i < count; i = next++)
                    task(i);
            } catch (const std::exception&) {
                const std::lock_guard lock(mutex);
                failure = std::current_exception();
                next = count;
            }
        };
        std::vector<std::jthread> others;
        for (int i = 1; i < threads && i < count; ++i)
            others.emplace_back(work);
        work();
        others.clear();  // joins
        if (failure) std::rethrow_exception(failure);
    };
}

}  // namespace vitrine::analyzer
