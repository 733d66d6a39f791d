#include "analyzer/watch/missing_pictures.hpp"

#include "base/system/log.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

MissingPictures::MissingPictures(EventLoop& loop, const ChildLimits& limits, std::function<void()> made)
    : loop_(loop), limits_(limits), made_(std::move(made)) {}

void MissingPictures::request(const Command& command) {
    if (std::ranges::find(waiting_, command) != waiting_.end()) return;
    waiting_.push_back(command);
    if (!child_) start_next();
}

void MissingPictures::request_once(const Command& command) {
    if (asked_once_.insert(command).second) request(command);
}

void MissingPictures::start_next() {
    while (!waiting_.empty() && !child_) {
        const auto end = [this](const ChildResult& result) {
            if (result.end != ChildResult::End::exited || result.code != 0)
                log::debug("no picture of '{}': {}", waiting_.front().back(), result.complaint);
            child_.reset();
            waiting_.pop_front();
            start_next();
            made_();
        };
        try {
            child_ = std::make_unique<ChildProcess>(loop_, waiting_.front(), limits_, end);
        } catch (const std::system_error& error) {  // no memory, no process
            log::debug("no picture of '{}': {}", waiting_.front().back(), error.what());
            waiting_.pop_front();
        }
    }
}

}  // namespace vitrine::analyzer
