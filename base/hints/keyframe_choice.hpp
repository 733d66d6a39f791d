#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The ending of a file beside a film that chooses the keyframes of its tapestry: the film's whole name, then
/// this.
constexpr std::string_view keyframe_file_ending = ".tapestry.toml";

/// An operator's choice of a film's keyframes. Empty: there is none.
struct KeyframeChoice {
    std::vector<std::chrono::nanoseconds> keyframes{};  // moments of the film that are keyframes, in order
    std::vector<std::chrono::nanoseconds> struck{};     // moments beside which no others are, in order
    bool is_only = false;                               // the coarsest level has no others

    bool operator==(const KeyframeChoice&) const = default;

    bool is_empty() const { return keyframes.empty() && struck.empty(); }
};

/// The choices by the paths of films, below the media folder.
using KeyframeChoices = std::map<std::string, KeyframeChoice>;

/// A moment so near to a struck one is struck, too.
constexpr std::chrono::milliseconds strike_reach{500};

/// The moments of one kind that a choice may have.
constexpr std::size_t max_moments_of_a_choice = 1000;

/// True for a moment beside a struck one.
bool is_struck(const KeyframeChoice& choice, std::chrono::nanoseconds moment);

/// The choice of a file with that of a technician's touches. Where they contradict, the touches count.
KeyframeChoice joined_choice(const KeyframeChoice& file, const KeyframeChoice& touched);

/// The content of such a file. A fault in one line does not affect the others.
struct KeyframeFile {
    KeyframeChoice choice;
    std::vector<std::string> faults;  // each with file, line and allowed values
};

/// Reads `keyframes`, `strike` and `only`. @param source  name of the text in the faults
KeyframeFile read_keyframe_choice(std::string_view toml, const std::string& source);

/// The shortest text that is read as this choice; the same for equal choices. "" for an empty one.
std::string to_toml(const KeyframeChoice& choice);

/// Identifies a choice: 32 hex digits; "" for an empty one.
std::string key_of(const KeyframeChoice& choice);

/// A sentence part for the operator: "3 keyframes chosen, 1 struck". "" for an empty choice.
std::string in_words(const KeyframeChoice& choice);

/// Parses "12", "12.5", "1:02", "1:02:03.5". @return  none: another text, or beyond 11 days
std::optional<std::chrono::nanoseconds> moment_named(std::string_view text);

/// True for the name of such a file.
bool is_keyframe_file(std::string_view name);

}  // namespace vitrine
