#include "player/display/card.hpp"

#include "base/system/error.hpp"
#include "base/system/handle.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <xf86drm.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace vitrine::player {

namespace {

using BlobHandle = Handle<drmModePropertyBlobRes, &drmModeFreePropertyBlob>;
using ConnectorHandle = Handle<drmModeConnector, &drmModeFreeConnector>;
using CrtcHandle = Handle<drmModeCrtc, &drmModeFreeCrtc>;
using EncoderHandle = Handle<drmModeEncoder, &drmModeFreeEncoder>;
using PlaneHandle = Handle<drmModePlane, &drmModeFreePlane>;
using PlanesHandle = Handle<drmModePlaneRes, &drmModeFreePlaneResources>;
using PropertiesHandle = Handle<drmModeObjectProperties, &drmModeFreeObjectProperties>;
using PropertyHandle = Handle<drmModePropertyRes, &drmModeFreeProperty>;
using RequestHandle = Handle<drmModeAtomicReq, &drmModeAtomicFree>;
using ResourcesHandle = Handle<drmModeRes, &drmModeFreeResources>;
using VersionHandle = Handle<drmVersion, &drmFreeVersion>;

// libdrm takes a pointer; the card only returns it with the event.
void* user_data(std::uint64_t number) {
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(number));  // NOLINT(performance-no-int-to-ptr)
}

template <typename T, typename N> std::span<T> list(T* first, N count) {
    return {first, static_cast<std::size_t>(count)};
}

// Calls visit(name, id, value) for each property of an object.
template <typename Visit>
void for_each_property(int fd, std::uint32_t object, std::uint32_t type, Visit visit) {
    const PropertiesHandle properties(drmModeObjectGetProperties(fd, object, type));
    if (!properties) return;
    for (std::uint32_t i = 0; i < properties->count_props; ++i) {
        const PropertyHandle property(drmModeGetProperty(fd, properties->props[i]));
        if (property) visit(std::string(property->name), property->prop_id, properties->prop_values[i]);
    }
}

PropertyIds property_ids(int fd, std::uint32_t object, std::uint32_t type) {
    PropertyIds ids;
    for_each_property(fd, object, type,
                      [&](const std::string& name, std::uint32_t id, std::uint64_t) { ids[name] = id; });
    return ids;
}

std::string name_of(const drmModeConnector& connector) {
    const char* const type = drmModeGetConnectorTypeName(connector.connector_type);
    return fmt::format("{}-{}", type ? type : "unknown", connector.connector_type_id);
}

// A number that differs if the blobs' contents differ. 0: there is no content.
std::uint64_t content_number(int fd, std::uint64_t blob) {
    const BlobHandle content(blob == 0 ? nullptr
                                       : drmModeGetPropertyBlob(fd, static_cast<std::uint32_t>(blob)));
    if (!content) return 0;
    return std::hash<std::string_view>()({static_cast<const char*>(content->data), content->length}) | 1U;
}

CardState::Connector described(int fd, const drmModeConnector& connector) {
    CardState::Connector made{.id = connector.connector_id,
                              .name = name_of(connector),
                              .is_connected = connector.connection == DRM_MODE_CONNECTED,
                              .crtcs = drmModeConnectorGetPossibleCrtcs(fd, &connector)};
    const EncoderHandle encoder(drmModeGetEncoder(fd, connector.encoder_id));
    if (encoder) made.crtc_id = encoder->crtc_id;
    made.millimetres = {static_cast<double>(connector.mmWidth), static_cast<double>(connector.mmHeight)};
    const auto modes = list(connector.modes, connector.count_modes);
    made.modes.assign(modes.begin(), modes.end());
    for_each_property(fd, made.id, DRM_MODE_OBJECT_CONNECTOR,
                      [&](const std::string& name, std::uint32_t, std::uint64_t value) {
                          if (name == "link-status") made.is_link_bad = value == DRM_MODE_LINK_STATUS_BAD;
                          if (name == "EDID") made.panel = content_number(fd, value);
                      });
    return made;
}

std::vector<CardState::Plane> planes(int fd) {
    std::vector<CardState::Plane> found;
    const PlanesHandle resources(drmModeGetPlaneResources(fd));
    if (!resources) return found;
    for (const std::uint32_t id : list(resources->planes, resources->count_planes)) {
        const PlaneHandle plane(drmModeGetPlane(fd, id));
        if (!plane) continue;
        CardState::Plane made{.id = id, .crtcs = plane->possible_crtcs, .crtc_id = plane->crtc_id};
        for_each_property(fd, id, DRM_MODE_OBJECT_PLANE,
                          [&](const std::string& name, std::uint32_t, std::uint64_t value) {
                              if (name == "type") made.is_primary = value == DRM_PLANE_TYPE_PRIMARY;
                          });
        found.push_back(made);
    }
    return found;
}

bool has_connectors(int fd) {
    const ResourcesHandle resources(drmModeGetResources(fd));
    return resources && resources->count_connectors > 0 && resources->count_crtcs > 0;
}

bool has_panel(const Card& card) {
    const std::optional<CardState> state = card.state([](std::uint32_t) { return true; });
    return state && std::ranges::any_of(state->connectors, &CardState::Connector::is_connected);
}

// The cards' files, in the order of their numbers.
std::vector<std::filesystem::path> card_files() {
    constexpr int max_cards = 64;
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < max_cards; ++i)
        if (std::filesystem::path file = fmt::format("/dev/dri/card{}", i); std::filesystem::exists(file))
            files.push_back(std::move(file));
    return files;
}

// None: the card only computes, or another program has it.
std::optional<Card> try_card(const std::filesystem::path& file, KmsApi api, std::string& reason) {
    try {
        return Card(file, api);
    } catch (const std::runtime_error& error) {
        reason += fmt::format("{}{}", reason.empty() ? "" : "; ", error.what());
        return std::nullopt;
    }
}

}  // namespace

Card::Card(const std::filesystem::path& path, KmsApi api)
    : path_(path), fd_(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK)) {
    if (!fd_.is_open()) throw_errno("open graphics card '{}'", path.string());
    frame_buffers_ = std::make_unique<FrameBuffers>(fd(), UniqueFd());
    if (!has_connectors(fd()))
        throw std::runtime_error(fmt::format("graphics card '{}' has no output", path.string()));
    if (!is_ours() && !take_over())
        throw std::runtime_error(fmt::format("another program uses graphics card '{}'", path.string()));

    if (api == KmsApi::best) {
        is_atomic_ = drmSetClientCap(fd(), DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) == 0 &&
                     drmSetClientCap(fd(), DRM_CLIENT_CAP_ATOMIC, 1) == 0;
    }
    std::uint64_t modifiers = 0;
    has_modifiers_ = drmGetCap(fd(), DRM_CAP_ADDFB2_MODIFIERS, &modifiers) == 0 && modifiers == 1;
}

std::string Card::driver() const {
    const VersionHandle version(drmGetVersion(fd()));
    return version ? version->name : "";
}

std::optional<CardState> Card::state(const std::function<bool(std::uint32_t)>& is_asked) const {
    const ResourcesHandle resources(drmModeGetResources(fd()));
    if (!resources) return std::nullopt;
    CardState state;
    for (const std::uint32_t id : list(resources->connectors, resources->count_connectors)) {
        const ConnectorHandle connector(is_asked(id) ? drmModeGetConnector(fd(), id)
                                                     : drmModeGetConnectorCurrent(fd(), id));
        if (connector) state.connectors.push_back(described(fd(), *connector));
    }
    const auto crtcs = list(resources->crtcs, resources->count_crtcs);
    state.crtcs.assign(crtcs.begin(), crtcs.end());
    if (is_atomic_) state.planes = planes(fd());
    return state;
}

OutputProperties Card::properties(const Output& output) const {
    return {.connector = property_ids(fd(), output.connector, DRM_MODE_OBJECT_CONNECTOR),
            .crtc = property_ids(fd(), output.crtc, DRM_MODE_OBJECT_CRTC),
            .plane = property_ids(fd(), output.plane, DRM_MODE_OBJECT_PLANE)};
}

void Card::set_keeper(UniqueFd keeper) {
    frame_buffers_ = std::make_unique<FrameBuffers>(fd(), std::move(keeper));
}

std::vector<std::uint32_t> Card::shown() const {
    std::vector<std::uint32_t> numbers;
    const ResourcesHandle resources(drmModeGetResources(fd()));
    if (!resources) return numbers;
    for (const std::uint32_t id : list(resources->crtcs, resources->count_crtcs)) {
        const CrtcHandle crtc(drmModeGetCrtc(fd(), id));
        if (crtc && crtc->buffer_id != 0) numbers.push_back(crtc->buffer_id);
    }
    return numbers;
}

int Card::commit(const AtomicRequest& request, std::uint32_t flags, std::uint64_t user) const {
    const RequestHandle list(drmModeAtomicAlloc());
    if (!list) return ENOMEM;
    for (const auto& [object, property, value] : request)
        if (drmModeAtomicAddProperty(list.get(), object, property, value) < 0) return ENOMEM;
    return -drmModeAtomicCommit(fd(), list.get(), flags, user_data(user));
}

// Does not use drmHandleEvent(): it calls back with a pointer that was given to the card. For a panel that
// has gone since, the pointer would be dangling.
std::vector<std::uint64_t> Card::read_flips() const {
    std::array<std::byte, 1024> events{};
    const ssize_t size = ::read(fd(), events.data(), events.size());
    if (size <= 0) return {};
    return flips_in(std::span(events).first(static_cast<std::size_t>(size)));
}

int Card::flip(std::uint32_t crtc, std::uint32_t frame_buffer, std::uint64_t user) const {
    return -drmModePageFlip(fd(), crtc, frame_buffer, DRM_MODE_PAGE_FLIP_EVENT, user_data(user));
}

bool Card::is_ours() const {
    return drmIsMaster(fd()) != 0;
}

bool Card::take_over() const {
    return drmSetMaster(fd()) == 0;
}

Card open_card(const std::filesystem::path& path, KmsApi api) {
    if (!path.empty()) return {path, api};

    std::optional<Card> unlit;
    std::string reason;
    for (const std::filesystem::path& file : card_files()) {
        std::optional<Card> card = try_card(file, api, reason);
        if (!card) continue;
        if (has_panel(*card)) return std::move(*card);
        if (!unlit) unlit = std::move(card);
    }
    if (unlit) return std::move(*unlit);
    throw std::runtime_error(fmt::format("no graphics card can be used: {}",
                                         reason.empty() ? "there is no /dev/dri/card*" : reason));
}

bool is_panel_elsewhere(const std::filesystem::path& path) {
    std::string ignored;
    return std::ranges::any_of(card_files(), [&](const std::filesystem::path& file) {
        if (file == path) return false;
        const std::optional<Card> card = try_card(file, KmsApi::legacy, ignored);
        return card && has_panel(*card);
    });
}

}  // namespace vitrine::player
