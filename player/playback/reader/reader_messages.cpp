#include "player/playback/reader/reader_messages.hpp"

#include <algorithm>
#include <string_view>

namespace vitrine::player {

namespace {

constexpr std::size_t max_text = 500;  // bytes of a reason

/// The numbers of an order. The names of the media folder and of the file follow.
struct OrderNumbers {
    static constexpr ReaderWord word = ReaderWord::order;
    std::uint32_t is_photo = 0;
    std::uint32_t form = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::uint32_t background = 0;
    SlotShape slots;
    std::uint32_t root_bytes = 0;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t at = 0;
};

struct FailureNumbers {
    static constexpr ReaderWord word = ReaderWord::failure;
    std::uint32_t owner = 0;
};

template <typename Numbers> std::vector<std::byte> with_text(const Numbers& numbers, std::string_view text) {
    std::vector<std::byte> message = to_message(numbers);
    const std::size_t before = message.size();
    message.resize(before + text.size());
    if (!text.empty()) std::memcpy(message.data() + before, text.data(), text.size());
    return message;
}

template <typename Numbers>
std::optional<Numbers> numbers_before(std::span<const std::byte> message, std::string& text) {
    constexpr std::size_t head = sizeof(ReaderWord) + sizeof(Numbers);
    if (message.size() < head) return std::nullopt;
    const std::span<const std::byte> rest = message.subspan(head);
    text.assign(rest.size(), '\0');
    if (!rest.empty()) std::memcpy(text.data(), rest.data(), rest.size());
    return note_in<Numbers>(message.first(head));
}

std::uint32_t to_number(const Colour& colour) {
    return std::uint32_t{colour.red} << 16U | std::uint32_t{colour.green} << 8U | colour.blue;
}

Colour to_colour(std::uint32_t number) {
    return {.red = static_cast<std::uint8_t>(number >> 16U),
            .green = static_cast<std::uint8_t>(number >> 8U),
            .blue = static_cast<std::uint8_t>(number)};
}

}  // namespace

std::vector<std::byte> to_message(const ReaderOrder& order) {
    return with_text(OrderNumbers{.is_photo = order.kind == MediaKind::photo ? 1U : 0U,
                                  .form = static_cast<std::uint32_t>(order.form),
                                  .width = order.width,
                                  .height = order.height,
                                  .background = to_number(order.background),
                                  .slots = order.slots,
                                  .root_bytes = static_cast<std::uint32_t>(order.root.size()),
                                  .begin = order.begin.count(),
                                  .end = order.end.count(),
                                  .at = order.at.count()},
                     order.root + order.path);
}

std::optional<ReaderOrder> order_in(std::span<const std::byte> message) {
    std::string names;
    const auto numbers = numbers_before<OrderNumbers>(message, names);
    if (!numbers || numbers->root_bytes > names.size()) return std::nullopt;
    return ReaderOrder{.kind = numbers->is_photo != 0 ? MediaKind::photo : MediaKind::film,
                       .root = names.substr(0, numbers->root_bytes),
                       .path = names.substr(numbers->root_bytes),
                       .width = numbers->width,
                       .height = numbers->height,
                       .background = to_colour(numbers->background),
                       .form = static_cast<PictureForm>(numbers->form),
                       .begin = std::chrono::nanoseconds(numbers->begin),
                       .end = std::chrono::nanoseconds(numbers->end),
                       .at = std::chrono::nanoseconds(numbers->at),
                       .slots = numbers->slots};
}

std::vector<std::byte> to_message(const FailureNote& failure) {
    return with_text(FailureNumbers{.owner = static_cast<std::uint32_t>(failure.owner)},
                     std::string_view(failure.text).substr(0, max_text));
}

std::optional<FailureNote> failure_in(std::span<const std::byte> message) {
    FailureNote failure;
    const auto numbers = numbers_before<FailureNumbers>(message, failure.text);
    if (!numbers) return std::nullopt;
    if (numbers->owner <= static_cast<std::uint32_t>(FaultOwner::program))
        failure.owner = static_cast<FaultOwner>(numbers->owner);
    failure.text.resize(std::min(failure.text.size(), max_text));
    return failure;
}

}  // namespace vitrine::player
