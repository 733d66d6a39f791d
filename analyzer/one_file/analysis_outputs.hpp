#pragma once

#include <array>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The by-products that an analysis writes, and how thoroughly it looks.
struct AnalysisOutputs {
    bool growth = false;       // each shot on the standard output as soon as it is over
    bool stored = false;       // clips or a copy in the store (settings.store), for the player to play from
    bool sound = false;        // a film's sound in the store too
    bool frames = false;       // a film's frames for its tapestry (settings.tapestry), where it has none yet
    bool thumbnail = false;    // for the status folder
    bool network = false;      // a photo's region by the network too (settings.analyzer.saliency)
    bool accepts_cut = false;  // accepts a stream that breaks off inside a packet: it will not grow any more
};

/// One output as a flag of `vitrine-analyzer analyze`.
struct OutputFlag {
    const char* name;
    bool AnalysisOutputs::*value;
    const char* help;
};

/// The only place where the outputs, their flags and the help are tied together.
constexpr std::array output_flags{
    OutputFlag{"--grow", &AnalysisOutputs::growth,
               "Prints each shot when it is found, at last the whole record"},
    OutputFlag{"--keep", &AnalysisOutputs::stored,
               "Puts the file into the store, from which the player plays it"},
    OutputFlag{"--frames", &AnalysisOutputs::frames, "Keeps a film's frames for its tapestry"},
    OutputFlag{"--sound", &AnalysisOutputs::sound, "Puts the sound of a film into the store, too"},
    OutputFlag{"--thumbnail", &AnalysisOutputs::thumbnail, "Writes a thumbnail for the status folder"},
    OutputFlag{"--network", &AnalysisOutputs::network, "Finds the region of a photo by the network too"},
    OutputFlag{"--as-it-is", &AnalysisOutputs::accepts_cut,
               "Accepts a stream that breaks off, as half a copy does"},
};

/// The flags that ask a child for these outputs.
inline std::vector<std::string> arguments_for(const AnalysisOutputs& outputs) {
    std::vector<std::string> arguments;
    for (const OutputFlag& flag : output_flags)
        if (outputs.*flag.value) arguments.emplace_back(flag.name);
    return arguments;
}

}  // namespace vitrine::analyzer
