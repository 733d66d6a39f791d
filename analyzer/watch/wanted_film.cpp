#include "analyzer/watch/wanted_film.hpp"

#include "base/state/keyframe_notes.hpp"
#include "base/state/wanted_tapestry.hpp"
#include "base/system/log.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

WantedFilm::WantedFilm(EventLoop& loop, std::filesystem::path state, Calls calls)
    : state_(std::move(state)), calls_(std::move(calls)) {
    std::error_code error;
    std::filesystem::create_directories(state_, error);
    if (!watch_.add(state_, true))
        log::warning("visitors' wishes are read at rescans only: '{}' cannot be watched: {}", state_.string(),
                     std::strerror(errno));
    events_ = loop.watch(watch_.fd(), EPOLLIN, [this](std::uint32_t) { handle_events(); });
    look();
}

void WantedFilm::look() {
    path_ = wanted_tapestry(state_, std::filesystem::file_time_type::clock::now());
}

void WantedFilm::handle_events() {
    const std::vector<DirectoryEvent> events = watch_.read();
    const auto tell_of = [&](std::string_view file) {
        return std::ranges::any_of(events, [&](const DirectoryEvent& event) {
            return event.name == file || event.kind == DirectoryEvent::Kind::overflow;
        });
    };
    if (tell_of(keyframe_notes_file)) calls_.noted();
    if (!tell_of(wanted_tapestry_file)) return;
    const std::string before = path_;
    look();
    if (path_ != before) calls_.wanted();
}

}  // namespace vitrine::analyzer
