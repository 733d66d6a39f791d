#include "player/input/touch.hpp"

#include "base/system/error.hpp"
#include "base/system/handle.hpp"

#include <fcntl.h>
#include <libinput.h>
#include <libudev.h>
#include <linux/input-event-codes.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int pointer_finger = -1;         // a mouse whose button is held; touch slots count from 0
constexpr Vec2 pointer_reach{1920, 1080};  // px that a mouse moves for a panel's width and height
constexpr double notch_angle = 120;        // libinput's unit for one notch
constexpr std::array<std::pair<unsigned, Key>, 17> keys{{{KEY_LEFT, Key::left},
                                                         {KEY_RIGHT, Key::right},
                                                         {KEY_UP, Key::nearer},
                                                         {KEY_DOWN, Key::farther},
                                                         {KEY_EQUAL, Key::nearer},
                                                         {KEY_KPPLUS, Key::nearer},
                                                         {KEY_MINUS, Key::farther},
                                                         {KEY_KPMINUS, Key::farther},
                                                         {KEY_PAGEUP, Key::left},
                                                         {KEY_PAGEDOWN, Key::right},
                                                         {KEY_ENTER, Key::select},
                                                         {KEY_KPENTER, Key::select},
                                                         {KEY_SPACE, Key::select},
                                                         {KEY_ESC, Key::back},
                                                         {KEY_BACKSPACE, Key::back},
                                                         {KEY_UNDO, Key::undo},
                                                         {KEY_Z, Key::undo}}};

std::chrono::nanoseconds time_of(std::uint64_t microseconds) {
    return std::chrono::microseconds(microseconds);
}

/// Called by libinput, from C: throws nothing. The flags are libinput's.
int open_device(const char* path, int flags, void* refused) {
    const int fd = ::open(path, flags | O_CLOEXEC);
    if (fd >= 0) return fd;
    const int error = errno;
    ++(*static_cast<std::map<int, int>*>(refused))[error];
    return -error;
}

void close_device(int fd, void* /*refused*/) {
    ::close(fd);
}

constexpr libinput_interface devices_interface{.open_restricted = open_device,
                                               .close_restricted = close_device};

/// The output that udev assigns to a device; empty: none.
std::string output_of(libinput_device* device) {
    const char* name = libinput_device_get_output_name(device);
    return name != nullptr ? name : "";
}

/// Drops libinput's own log lines: the player logs each device once itself.
void ignore_log(libinput* /*context*/, libinput_log_priority /*priority*/, const char* /*format*/,
                va_list /*arguments*/) {}

}  // namespace

struct Touch::Context {
    explicit Context(const std::string& devices);

    void open_seat();
    void open_paths(const std::string& devices);
    void handle_event(libinput_event* event);
    void handle_device(libinput_device* device, bool is_added);
    void handle_touch(libinput_event_touch* touch, libinput_event_type type, const std::string& output);
    void handle_pointer(libinput_event_pointer* pointer, libinput_event_type type, const std::string& output);
    void handle_wheel(libinput_event_pointer* pointer, const std::string& output);
    void handle_key(libinput_event_keyboard* press, const std::string& output);
    int finger_of(libinput_event_touch* touch);
    void report_refusals();

    std::map<int, int> refused;  // errno -> number of devices that could not be opened
    Handle<udev, &udev_unref> rules;
    Handle<libinput, &libinput_unref> input;
    std::map<std::pair<libinput_device*, int>, int> fingers;  // device and slot -> number
    Vec2 pointer{0.5, 0.5};                                   // shares of the panel's sides
    bool is_pressed = false;
    std::chrono::nanoseconds newest{0};  // time of the last touch
    std::vector<PanelEvent> events;
    std::vector<std::string> news;
};

Touch::Context::Context(const std::string& devices) {
    if (devices == "auto")
        open_seat();
    else
        open_paths(devices);
}

void Touch::Context::open_seat() {
    rules.reset(udev_new());
    if (!rules) throw std::runtime_error("udev cannot be used");
    input.reset(libinput_udev_create_context(&devices_interface, &refused, rules.get()));
    if (!input) throw std::runtime_error("libinput cannot be used");
    libinput_log_set_handler(input.get(), ignore_log);
    if (libinput_udev_assign_seat(input.get(), "seat0") != 0)
        throw std::runtime_error("udev does not list the devices");
}

void Touch::Context::open_paths(const std::string& devices) {
    input.reset(libinput_path_create_context(&devices_interface, &refused));
    if (!input) throw std::runtime_error("libinput cannot be used");
    libinput_log_set_handler(input.get(), ignore_log);
    std::istringstream list(devices);
    for (std::string path; std::getline(list >> std::ws, path, ',');)
        if (libinput_path_add_device(input.get(), path.c_str()) == nullptr)
            news.push_back(fmt::format("'{}' cannot be used", path));
}

void Touch::Context::handle_event(libinput_event* event) {
    const libinput_event_type type = libinput_event_get_type(event);
    libinput_device* device = libinput_event_get_device(event);
    const std::string output = output_of(device);
    switch (type) {
    case LIBINPUT_EVENT_DEVICE_ADDED:
    case LIBINPUT_EVENT_DEVICE_REMOVED:
        return handle_device(device, type == LIBINPUT_EVENT_DEVICE_ADDED);
    case LIBINPUT_EVENT_TOUCH_DOWN:
    case LIBINPUT_EVENT_TOUCH_MOTION:
    case LIBINPUT_EVENT_TOUCH_UP:
    case LIBINPUT_EVENT_TOUCH_CANCEL:
        return handle_touch(libinput_event_get_touch_event(event), type, output);
    case LIBINPUT_EVENT_POINTER_MOTION:
    case LIBINPUT_EVENT_POINTER_MOTION_ABSOLUTE:
    case LIBINPUT_EVENT_POINTER_BUTTON:
        return handle_pointer(libinput_event_get_pointer_event(event), type, output);
    case LIBINPUT_EVENT_POINTER_SCROLL_WHEEL:
        return handle_wheel(libinput_event_get_pointer_event(event), output);
    case LIBINPUT_EVENT_KEYBOARD_KEY:
        return handle_key(libinput_event_get_keyboard_event(event), output);
    default:
        return;
    }
}

/// Adds or removes a device. The fingers of a removed device are lost, if libinput has not lifted them.
void Touch::Context::handle_device(libinput_device* device, bool is_added) {
    news.push_back(fmt::format("{} '{}'", is_added ? "found" : "gone:", libinput_device_get_name(device)));
    if (is_added && libinput_device_config_tap_get_finger_count(device) > 0)
        libinput_device_config_tap_set_enabled(device, LIBINPUT_CONFIG_TAP_ENABLED);
    if (is_added) return;
    for (const auto& [key, finger] : fingers)
        if (key.first == device)
            events.push_back({output_of(device),
                              Contact{.kind = Contact::Kind::cancel, .finger = finger, .time = newest}});
    std::erase_if(fingers, [&](const auto& entry) { return entry.first.first == device; });
}

/// The number of a device's finger. No other finger has it at the same time.
int Touch::Context::finger_of(libinput_event_touch* touch) {
    libinput_device* device = libinput_event_get_device(libinput_event_touch_get_base_event(touch));
    const std::pair key{device, libinput_event_touch_get_slot(touch)};
    if (const auto known = fingers.find(key); known != fingers.end()) return known->second;
    int number = 0;
    while (std::ranges::any_of(fingers, [&](const auto& entry) { return entry.second == number; }))
        ++number;
    fingers[key] = number;
    return number;
}

void Touch::Context::handle_touch(libinput_event_touch* touch, libinput_event_type type,
                                  const std::string& output) {
    Contact contact{.finger = finger_of(touch), .time = time_of(libinput_event_touch_get_time_usec(touch))};
    newest = contact.time;
    if (type == LIBINPUT_EVENT_TOUCH_DOWN || type == LIBINPUT_EVENT_TOUCH_MOTION) {
        contact.kind = type == LIBINPUT_EVENT_TOUCH_DOWN ? Contact::Kind::down : Contact::Kind::move;
        contact.at = {libinput_event_touch_get_x_transformed(touch, 1),
                      libinput_event_touch_get_y_transformed(touch, 1)};
    } else {
        contact.kind = type == LIBINPUT_EVENT_TOUCH_UP ? Contact::Kind::up : Contact::Kind::cancel;
        std::erase_if(fingers, [&](const auto& entry) { return entry.second == contact.finger; });
    }
    events.push_back({output, contact});
}

void Touch::Context::handle_pointer(libinput_event_pointer* moved, libinput_event_type type,
                                    const std::string& output) {
    Contact contact{.finger = pointer_finger, .time = time_of(libinput_event_pointer_get_time_usec(moved))};
    if (type == LIBINPUT_EVENT_POINTER_BUTTON) {
        if (libinput_event_pointer_get_button(moved) != BTN_LEFT) return;
        is_pressed = libinput_event_pointer_get_button_state(moved) == LIBINPUT_BUTTON_STATE_PRESSED;
        contact.kind = is_pressed ? Contact::Kind::down : Contact::Kind::up;
    } else {
        contact.kind = Contact::Kind::move;
        if (type == LIBINPUT_EVENT_POINTER_MOTION_ABSOLUTE)
            pointer = {libinput_event_pointer_get_absolute_x_transformed(moved, 1),
                       libinput_event_pointer_get_absolute_y_transformed(moved, 1)};
        else
            pointer = pointer + Vec2{libinput_event_pointer_get_dx(moved) / pointer_reach.x,
                                     libinput_event_pointer_get_dy(moved) / pointer_reach.y};
        pointer = {std::clamp(pointer.x, 0.0, 1.0), std::clamp(pointer.y, 0.0, 1.0)};
        if (!is_pressed) return;
    }
    contact.at = pointer;
    events.push_back({output, contact});
}

void Touch::Context::handle_wheel(libinput_event_pointer* turned, const std::string& output) {
    constexpr auto axis = LIBINPUT_POINTER_AXIS_SCROLL_VERTICAL;
    if (libinput_event_pointer_has_axis(turned, axis) == 0) return;
    const double notches = -libinput_event_pointer_get_scroll_value_v120(turned, axis) / notch_angle;
    events.push_back({output, Wheel{.notches = notches,
                                    .at = pointer,
                                    .time = time_of(libinput_event_pointer_get_time_usec(turned))}});
}

void Touch::Context::handle_key(libinput_event_keyboard* press, const std::string& output) {
    if (libinput_event_keyboard_get_key_state(press) != LIBINPUT_KEY_STATE_PRESSED) return;
    const unsigned code = libinput_event_keyboard_get_key(press);
    const auto known = std::ranges::find_if(keys, [&](const auto& entry) { return entry.first == code; });
    if (known == keys.end()) return;
    events.push_back({output, KeyPress{.key = known->second,
                                       .time = time_of(libinput_event_keyboard_get_time_usec(press))}});
}

void Touch::Context::report_refusals() {
    for (const auto& [error, count] : std::exchange(refused, {}))
        news.push_back(fmt::format("{} {} cannot be opened: {}", count, count == 1 ? "device" : "devices",
                                   std::strerror(error)));
}

Touch::Touch(const std::string& devices) : context_(std::make_unique<Context>(devices)) {}

Touch::~Touch() = default;

int Touch::event_fd() const {
    return libinput_get_fd(context_->input.get());
}

std::vector<PanelEvent> Touch::read_events() {
    libinput* input = context_->input.get();
    if (const int result = libinput_dispatch(input); result < 0) {
        errno = -result;
        throw_errno("read input devices");
    }
    while (libinput_event* event = libinput_get_event(input)) {
        context_->handle_event(event);
        libinput_event_destroy(event);
    }
    context_->report_refusals();
    return std::exchange(context_->events, {});
}

std::vector<std::string> Touch::take_news() {
    return std::exchange(context_->news, {});
}

void Touch::suspend() {
    libinput_suspend(context_->input.get());
}

void Touch::resume() {
    (void)libinput_resume(context_->input.get());  // read_events() reports devices that cannot be opened
}

}  // namespace vitrine::player
