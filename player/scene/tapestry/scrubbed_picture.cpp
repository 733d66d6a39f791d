#include "player/scene/tapestry/scrubbed_picture.hpp"

#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto span_looked_at = 60s;  // so long a part is asked for, because it plays when the finger lets go
constexpr auto one_picture = 40ms;    // moments nearer to each other show the same picture of most films

}  // namespace

void ScrubbedPicture::look_at(nanoseconds moment, double width) {
    moment_ = spans_.possible_begin(moment);
    if (coming_) return;
    if (sharp_ && std::chrono::abs(sharp_->span.begin - *moment_) <= one_picture) return;
    coming_ = spans_.request({*moment_, *moment_ + span_looked_at}, width);
}

std::optional<PlayingSpan> ScrubbedPicture::take(nanoseconds moment) {
    if (!sharp_ || std::chrono::abs(sharp_->span.begin - moment) > one_picture) return std::nullopt;
    return std::exchange(sharp_, std::nullopt);
}

void ScrubbedPicture::stop() {
    moment_.reset();
    spans_.retire(sharp_);
    spans_.retire(coming_);
}

void ScrubbedPicture::source_ready(SourceId source) {
    if (!coming_ || coming_->source != source) return;
    spans_.retire(sharp_);
    sharp_ = std::exchange(coming_, std::nullopt);
}

std::optional<FilmSpan> ScrubbedPicture::source_failed(SourceId source) {
    std::optional<FilmSpan> failed;
    for (std::optional<PlayingSpan>* span : {&sharp_, &coming_})
        if (*span && (*span)->source == source) {
            failed = (*span)->span;
            spans_.retire(*span);
        }
    return failed;
}

}  // namespace vitrine::player
