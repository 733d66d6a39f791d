#include "player/control/bus_messages.hpp"

#include "base/system/log.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::uint32_t max_side = 32768;   // px, of a picture
constexpr std::size_t max_name = PATH_MAX;  // bytes of a file's name, or a folder's
constexpr const char* picture_list = "a(suuh)";

/// Calls `use` with each part of a signature: "ay", "u", "b".
template <typename Use> void for_each_part(std::string_view signature, const Use& use) {
    while (!signature.empty()) {
        const std::string_view part = signature.substr(0, signature.front() == 'a' ? 2 : 1);
        use(part);
        signature.remove_prefix(part.size());
    }
}

void append_bytes(sd_bus_message& message, const std::string& bytes) {
    bus_checked(sd_bus_message_append_array(&message, 'y', bytes.data(), bytes.size()), "write a name");
}

std::string read_bytes(sd_bus_message& message) {
    const void* bytes = nullptr;
    std::size_t size = 0;
    bus_checked(sd_bus_message_read_array(&message, 'y', &bytes, &size), "read a name");
    if (size > max_name) throw std::runtime_error(fmt::format("a name has at most {} bytes", max_name));
    return {static_cast<const char*>(bytes), size};
}

Picture picture_of(int file, std::uint32_t width, std::uint32_t height) {
    if (width > max_side || height > max_side)
        throw std::runtime_error("the player's picture has an impossible size");
    Picture picture{.width = static_cast<int>(width), .height = static_cast<int>(height), .pixels = {}};
    picture.pixels.resize(std::size_t{width} * height * 4);
    for (std::size_t done = 0; done < picture.pixels.size();) {
        const std::span<std::byte> left = std::span(picture.pixels).subspan(done);
        const ssize_t n = ::pread(file, left.data(), left.size(), static_cast<off_t>(done));
        if (n <= 0) throw std::runtime_error("the player's picture is cut off");
        done += static_cast<std::size_t>(n);
    }
    return picture;
}

std::vector<OutputPicture> read_pictures(sd_bus_message& message) {
    std::vector<OutputPicture> pictures;
    bus_checked(sd_bus_message_enter_container(&message, 'a', "(suuh)"), "read pictures");
    const char* output = nullptr;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int file = -1;
    while (bus_checked(sd_bus_message_read(&message, "(suuh)", &output, &width, &height, &file),
                       "read a picture") > 0)
        pictures.push_back({.output = output, .picture = picture_of(file, width, height)});
    return pictures;
}

}  // namespace

void reply_error(sd_bus_message& call, const char* error, const std::string& why) {
    if (sd_bus_reply_method_errorf(&call, error, "%s", why.c_str()) >= 0) return;
    std::string plain = why;  // the bus takes only UTF-8; file names may hold other bytes
    std::ranges::replace_if(
        plain, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
    if (sd_bus_reply_method_errorf(&call, error, "%s", plain.c_str()) < 0)
        log::debug("nobody waits for this answer: {}", why);
}

void reply(sd_bus_message& call, const std::function<void(sd_bus_message&)>& fill) {
    try {
        sd_bus_message* made = nullptr;
        bus_checked(sd_bus_message_new_method_return(&call, &made), "make an answer");
        const MessageHandle message(made);
        fill(*made);
        bus_checked(sd_bus_send(nullptr, made, nullptr), "answer");
    } catch (const std::exception& error) {  // the caller gets it
        reply_error(call, error_failed, error.what());
    }
}

PictureFile file_of(const OutputPicture& shown) {
    UniqueFd file(::memfd_create("picture", MFD_CLOEXEC));
    if (!file.is_open()) throw_errno("make a file for a picture");
    for (std::span<const std::byte> left = shown.picture.pixels; !left.empty();) {
        const ssize_t n = ::write(file.get(), left.data(), left.size());
        if (n < 0) throw_errno("write a picture");
        left = left.subspan(static_cast<std::size_t>(n));
    }
    return {.output = shown.output,
            .width = static_cast<std::uint32_t>(shown.picture.width),
            .height = static_cast<std::uint32_t>(shown.picture.height),
            .file = std::move(file)};
}

void append_pictures(sd_bus_message& message, std::span<const PictureFile> pictures) {
    bus_checked(sd_bus_message_open_container(&message, 'a', "(suuh)"), "answer pictures");
    for (const PictureFile& one : pictures)
        bus_checked(sd_bus_message_append(&message, "(suuh)", one.output.c_str(), one.width, one.height,
                                          one.file.get()),
                    "answer a picture");
    bus_checked(sd_bus_message_close_container(&message), "answer pictures");
}

void append_call(sd_bus_message& message, std::string_view arguments, const CommandCall& call) {
    bool has_file = false;
    for_each_part(arguments, [&](std::string_view part) {
        if (part == "ay") {
            append_bytes(message, has_file ? call.folder : call.file);
            has_file = true;
        } else if (part == "u") {
            const auto slot = static_cast<std::uint32_t>(call.slot);
            bus_checked(sd_bus_message_append(&message, "u", slot), "write a number");
        } else {
            bus_checked(sd_bus_message_append(&message, "b", call.is_on ? 1 : 0), "write a flag");
        }
    });
}

CommandCall read_call(sd_bus_message& message, std::string_view arguments) {
    CommandCall call;
    bool has_file = false;
    for_each_part(arguments, [&](std::string_view part) {
        if (part == "ay") {
            (has_file ? call.folder : call.file) = read_bytes(message);
            has_file = true;
        } else if (part == "u") {
            std::uint32_t slot = 0;
            bus_checked(sd_bus_message_read(&message, "u", &slot), "read a number");
            constexpr std::uint32_t max_slot = std::numeric_limits<int>::max();
            call.slot = static_cast<int>(std::min(slot, max_slot));
        } else {
            int flag = 0;
            bus_checked(sd_bus_message_read(&message, "b", &flag), "read a flag");
            call.is_on = flag != 0;
        }
    });
    return call;
}

void append_answer(sd_bus_message& message, std::string_view result, const CommandAnswer& answer) {
    if (result == "s") bus_checked(sd_bus_message_append(&message, "s", answer.text.c_str()), "answer");
    if (result == "ay") append_bytes(message, answer.text);
}

CommandAnswer read_answer(sd_bus_message& message, std::string_view result) {
    CommandAnswer answer;
    if (result == "ay") answer.text = read_bytes(message);
    if (result == picture_list) answer.pictures = read_pictures(message);
    if (result == "s") {
        const char* text = nullptr;
        bus_checked(sd_bus_message_read(&message, "s", &text), "read an answer");
        answer.text = text;
    }
    return answer;
}

}  // namespace vitrine::player
