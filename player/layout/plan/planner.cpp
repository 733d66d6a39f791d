#include "player/layout/plan/planner.hpp"

#include <utility>

namespace vitrine::player {

Planner::Planner(std::function<void()> on_layout)
    : on_layout_(std::move(on_layout)), thread_([this] { run(); }) {}

Planner::~Planner() {
    stopping_ = true;
    {
        const std::lock_guard lock(mutex_);
        has_news_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Planner::request_layout(PlanRequest request, std::uint64_t generation) {
    request_layout([request = std::move(request)](const PlanWatch& watch) { return plan(request, watch); },
                   generation);
}

void Planner::request_layout(Making make, std::uint64_t generation) {
    {
        const std::lock_guard lock(mutex_);
        newest_ = generation;
        jobs_.put({std::move(make), generation});
        has_news_ = true;
    }
    wake_.notify_one();
}

std::optional<Layout> Planner::pop_layout() {
    std::optional<Layout> layout = layouts_.take();
    if (layout && layout->generation != newest_) layout.reset();
    return layout;
}

void Planner::run() {
    while (!stopping_) {
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return has_news_; });
            has_news_ = false;
        }
        if (const std::optional<Job> job = jobs_.take()) plan_job(*job);
    }
}

void Planner::plan_job(const Job& job) {
    constexpr double worth_showing = 0.005;  // share of the canvas
    double shown = 2;                        // energy of the last layout that was put
    const auto put = [&](Layout layout, bool is_final) {
        if (is_obsolete(job.generation)) return;
        if (!is_final && layout.energy > shown - worth_showing) return;
        shown = layout.energy;
        layout.generation = job.generation;
        layout.is_final = is_final;
        layouts_.put(std::move(layout));
        if (on_layout_) on_layout_();
    };
    const PlanWatch watch{.on_better = [&](const Layout& layout) { put(layout, false); },
                          .should_stop = [&] { return is_obsolete(job.generation); }};
    put(job.make(watch), true);
}

}  // namespace vitrine::player
