#include "player/playback/reader/reading.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

std::unique_ptr<ReaderLink> started_link(ReaderHost& host, ReaderOrder& order, std::size_t slots) {
    const std::optional<SlotShape> shape = slots_for(slots, order.width, order.height, order.form);
    if (!shape) throw std::runtime_error("a picture of this size cannot be shown");
    order.slots = *shape;
    const UniqueFd memory = new_slot_memory(*shape);
    return std::make_unique<ReaderLink>(host.start_reader(order, memory), order, memory);
}

}  // namespace

Reading::Reading(ReaderHost& host, ReaderOrder order, std::size_t slots, SampleQueue& queue)
    : is_photo_(order.kind == MediaKind::photo), queue_(queue) {
    try {
        link_ = started_link(host, order, slots);
        thread_ = std::thread([this] { run(); });
    } catch (const std::exception& error) {
        set_end({.text = error.what()});
    }
}

Reading::~Reading() {
    if (!has_ended_) {
        stop();
        queue_.close();
        link_->leave();
    }
    if (thread_.joinable()) thread_.join();
}

void Reading::stop() {
    is_stopped_ = true;
    if (link_) link_->stop();
}

std::optional<std::string> Reading::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

/// After stop() the pictures are dropped by the queue, which is closed, until the reader has ended.
void Reading::run() {
    while (std::optional<ReaderPicture> picture = link_->next()) {
        spent_ = picture->spent;
        queue_.put(std::move(picture->picture));
        if (!is_photo_) continue;
        link_->stop();
        has_ended_ = true;
        return;
    }
    set_end(link_->end());
}

void Reading::set_end(const ReaderEnd& end) {
    if (!is_stopped_) {
        has_crashed_ = end.has_crashed;
        const std::lock_guard lock(mutex_);
        failure_ = end.text;
    }
    queue_.close();
    has_ended_ = true;
}

}  // namespace vitrine::player
