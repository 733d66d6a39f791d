#include "player/control/picture_answers.hpp"

#include "base/system/event_file.hpp"

#include <sys/epoll.h>

#include <chrono>
#include <utility>

namespace vitrine::player {

using namespace std::chrono_literals;

PictureAnswers::PictureAnswers(EventLoop& loop)
    : made_(event_file()),
      told_(loop.watch(made_.get(), EPOLLIN, [this](std::uint32_t) { send_answers(); })) {}

void PictureAnswers::answer(sd_bus_message& call, std::function<std::vector<OutputPicture>()> make) {
    std::packaged_task<std::vector<PictureFile>()> task([make = std::move(make)] {
        std::vector<PictureFile> files;
        for (const OutputPicture& picture : make())
            files.push_back(file_of(picture));
        return files;
    });
    calls_.push_back({.message = {sd_bus_message_ref(&call), &sd_bus_message_unref},
                      .files = task.get_future(),
                      .thread = std::jthread([task = std::move(task), event = made_.get()]() mutable {
                          task();
                          ring(event);
                      })});
}

void PictureAnswers::send_answers() {
    quiet(made_.get());
    std::erase_if(calls_, [](Call& call) {
        if (call.files.wait_for(0s) != std::future_status::ready) return false;
        reply(*call.message, [&](sd_bus_message& made) { append_pictures(made, call.files.get()); });
        return true;
    });
}

}  // namespace vitrine::player
