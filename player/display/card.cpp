#include "player/display/card.hpp"

#include "base/system/error.hpp"
#include "base/system/handle.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <xf86drm.h>

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>

namespace vitrine {

namespace {

using ConnectorHandle = Handle<drmModeConnector, &drmModeFreeConnector>;
using EncoderHandle = Handle<drmModeEncoder, &drmModeFreeEncoder>;
using PlaneHandle = Handle<drmModePlane, &drmModeFreePlane>;
using PlanesHandle = Handle<drmModePlaneRes, &drmModeFreePlaneResources>;
using PropertiesHandle = Handle<drmModeObjectProperties, &drmModeFreeObjectProperties>;
using PropertyHandle = Handle<drmModePropertyRes, &drmModeFreeProperty>;
using RequestHandle = Handle<drmModeAtomicReq, &drmModeAtomicFree>;
using ResourcesHandle = Handle<drmModeRes, &drmModeFreeResources>;

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

CardState::Connector described(int fd, const drmModeConnector& connector) {
    CardState::Connector made{.id = connector.connector_id,
                              .name = name_of(connector),
                              .is_connected = connector.connection == DRM_MODE_CONNECTED,
                              .crtcs = drmModeConnectorGetPossibleCrtcs(fd, &connector)};
    const EncoderHandle encoder(drmModeGetEncoder(fd, connector.encoder_id));
    if (encoder) made.crtc_id = encoder->crtc_id;
    const auto modes = list(connector.modes, connector.count_modes);
    made.modes.assign(modes.begin(), modes.end());
    return made;
}

std::vector<CardState::Plane> planes(int fd) {
    std::vector<CardState::Plane> found;
    const PlanesHandle resources(drmModeGetPlaneResources(fd));
    if (!resources) return found;
    for (const std::uint32_t id : list(resources->planes, resources->count_planes)) {
        const PlaneHandle plane(drmModeGetPlane(fd, id));
        if (!plane) continue;
        CardState::Plane made{.id = id, .crtcs = plane->possible_crtcs};
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
    const CardState state = card.state(true);
    return std::ranges::any_of(state.connectors, &CardState::Connector::is_connected);
}

// Why nothing can be shown on a card; nothing when it can.
std::optional<std::string> fault(const std::filesystem::path& path) {
    const UniqueFd fd(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (!fd.is_open()) return std::generic_category().message(errno);
    if (!has_connectors(fd.get())) return "has no connector";  // it only computes
    return std::nullopt;
}

}  // namespace

Card::Card(const std::filesystem::path& path, KmsApi api)
    : path_(path), fd_(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK)) {
    if (!fd_.is_open()) throw_errno("open graphics card '{}'", path.string());
    if (!has_connectors(fd()))
        throw std::runtime_error(
            fmt::format("graphics card '{}' has no connector to show on", path.string()));

    if (api == KmsApi::best) {
        is_atomic_ = drmSetClientCap(fd(), DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) == 0 &&
                     drmSetClientCap(fd(), DRM_CLIENT_CAP_ATOMIC, 1) == 0;
    }
    std::uint64_t modifiers = 0;
    has_modifiers_ = drmGetCap(fd(), DRM_CAP_ADDFB2_MODIFIERS, &modifiers) == 0 && modifiers == 1;
}

CardState Card::state(bool asks_panels) const {
    CardState state;
    const ResourcesHandle resources(drmModeGetResources(fd()));
    if (!resources) return state;  // the card is gone: nothing is connected
    for (const std::uint32_t id : list(resources->connectors, resources->count_connectors)) {
        const ConnectorHandle connector(asks_panels ? drmModeGetConnector(fd(), id)
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

int Card::commit(const AtomicRequest& request, std::uint32_t flags, void* user) const {
    const RequestHandle list(drmModeAtomicAlloc());
    if (!list) return ENOMEM;
    for (const auto& [object, property, value] : request)
        if (drmModeAtomicAddProperty(list.get(), object, property, value) < 0) return ENOMEM;
    return -drmModeAtomicCommit(fd(), list.get(), flags, user);
}

Card open_card(const std::filesystem::path& path, KmsApi api) {
    if (!path.empty()) return {path, api};

    constexpr int most_cards = 64;
    std::optional<Card> unlit;
    std::string reason;
    for (int i = 0; i < most_cards; ++i) {
        const std::filesystem::path file = fmt::format("/dev/dri/card{}", i);
        if (!std::filesystem::exists(file)) continue;
        if (const std::optional<std::string> why = fault(file)) {
            reason += fmt::format("{}'{}' {}", reason.empty() ? "" : ", ", file.string(), *why);
            continue;
        }
        std::optional<Card> card(std::in_place, file,
                                 api);  // opened once only: the first opener is the master
        if (has_panel(*card)) return std::move(*card);
        if (!unlit) unlit = std::move(card);
    }
    if (unlit) return std::move(*unlit);
    throw std::runtime_error(fmt::format("no graphics card to show on: {}",
                                         reason.empty() ? "there is no /dev/dri/card*" : reason));
}

}  // namespace vitrine
