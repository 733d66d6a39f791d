#pragma once

#include "player/display/kms_state.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vitrine::player {

/// The numbers that a card gives to the properties of one object, by name.
using PropertyIds = std::map<std::string, std::uint32_t, std::less<>>;

/// The properties of the objects that feed one output. A property has one number for the whole card.
struct OutputProperties {
    PropertyIds connector;
    PropertyIds crtc;
    PropertyIds plane;
};

/// One change of a graphics card's state. A request is a list of changes; the card accepts all of them or
/// none.
struct PropertyValue {
    std::uint32_t object = 0;
    std::uint32_t property = 0;
    std::uint64_t value = 0;

    bool operator==(const PropertyValue&) const = default;
};

using AtomicRequest = std::vector<PropertyValue>;

/// Lights the panel with a frame buffer of the mode's size, and removes the obstacles.
/// @param mode_blob  the card's number for the output's mode
/// @throws std::runtime_error naming a property that the card lacks
AtomicRequest modeset_request(const Output& output, const OutputProperties& properties,
                              std::uint32_t mode_blob, std::uint32_t frame_buffer,
                              const Obstacles& in_the_way = {});

/// Shows another frame buffer of the same size on the lit panel.
AtomicRequest flip_request(const Output& output, const OutputProperties& properties,
                           std::uint32_t frame_buffer);

/// Turns the panel off: its signal ends. Mode and picture stay for modeset_request().
AtomicRequest off_request(const Output& output, const OutputProperties& properties);

}  // namespace vitrine::player
