#pragma once

#include "base/system/mailbox.hpp"
#include "player/layout/plan/plan.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace vitrine::player {

/// Thread-safe. Makes plans on a thread of its own, so that no frame waits for one. A new request replaces
/// the one before, which is given up.
class Planner {
  public:
    /// @param on_layout  called on the planner's thread when a layout is ready; must not call the planner
    explicit Planner(std::function<void()> on_layout = {});

    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;
    Planner(Planner&&) = delete;
    Planner& operator=(Planner&&) = delete;

    /// Gives up the plan in the making, and joins the thread.
    ~Planner();

    /// Makes a layout. @return the final one; better and better ones before it are told to the watch
    using Making = std::function<Layout(const PlanWatch& watch)>;

    /// @param generation  a number for the request's layouts, chosen by the caller: greater than all before
    void request_layout(PlanRequest request, std::uint64_t generation);

    /// The same for another way to make a layout. @param make  called on the planner's thread
    void request_layout(Making make, std::uint64_t generation);

    /// Removes and returns the best layout of the newest request. None: there is no new one since the last
    /// call. The last layout of a request is marked `is_final`. The layouts before it are free of overlap
    /// too, but looser.
    std::optional<Layout> pop_layout();

  private:
    struct Job {
        Making make;
        std::uint64_t generation = 0;
    };

    void run();
    void plan_job(const Job& job);

    bool is_obsolete(std::uint64_t generation) const { return stopping_ || generation != newest_; }

    std::function<void()> on_layout_;
    Mailbox<Job> jobs_;
    Mailbox<Layout> layouts_;
    std::atomic<std::uint64_t> newest_ = 0;
    std::atomic<bool> stopping_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool has_news_ = false;  // guarded by mutex_
    std::thread thread_;     // last: it uses all members above
};

}  // namespace vitrine::player
