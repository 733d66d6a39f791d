#pragma once

#include <array>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// By-products of an analysis to write, and whether truncated streams are accepted.
struct AnalysisOutputs {
    bool growth = false;       // each shot on the standard output as soon as it is over
    bool stored = false;       // clips or a copy in the store (settings.store), for the player to play from
    bool sound = false;        // a film's sound in the store too
    bool frames = false;       // a film's frames for its tapestry (settings.tapestry), where it has none yet
    bool thumbnail = false;    // for the status folder
    bool accepts_cut = false;  // a stream that breaks off inside a packet was waited for long enough
};

/// One output as a flag of `vitrine-analyzer analyze`.
struct OutputFlag {
    const char* name;
    bool AnalysisOutputs::*value;
    const char* help;
};

/// The only place where the outputs, their flags and the help are tied together.
constexpr std::array output_flags{
    OutputFlag{"--grow", &AnalysisOutputs::growth, "Print each shot as it is found, the whole record last"},
    OutputFlag{"--keep", &AnalysisOutputs::stored, "Put it into the store, for the player to play from"},
    OutputFlag{"--frames", &AnalysisOutputs::frames, "Keep a film's frames for its tapestry"},
    OutputFlag{"--sound", &AnalysisOutputs::sound, "Put the sound of a film into the store, too"},
    OutputFlag{"--thumbnail", &AnalysisOutputs::thumbnail, "Write a thumbnail for the status folder"},
    OutputFlag{"--as-it-is", &AnalysisOutputs::accepts_cut,
               "Do not wait for the rest of a stream that breaks off"},
};

/// The flags that ask a child for these outputs.
inline std::vector<std::string> arguments_for(const AnalysisOutputs& outputs) {
    std::vector<std::string> arguments;
    for (const OutputFlag& flag : output_flags)
        if (outputs.*flag.value) arguments.emplace_back(flag.name);
    return arguments;
}

}  // namespace vitrine::analyzer
