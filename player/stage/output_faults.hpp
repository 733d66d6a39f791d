#pragma once

#include <span>
#include <string>
#include <vector>

namespace vitrine {

struct Settings;

}

namespace vitrine::player {

class RecordList;
class Screen;
struct OtherOutputs;

/// Finds what the settings say of outputs and cannot be, as the outputs are: parts of output.canvas that
/// overlap; a name that is that of no output, while there is an output without a name; a folder without
/// files. Logs each once.
class OutputFaults {
  public:
    /// Keeps the last faults while there is no output.
    /// @param screens  of this box; none: its outputs may be off
    /// @param others   outputs of other boxes
    /// @param files    of the media folder
    void look(const Settings& settings, std::span<Screen* const> screens, const OtherOutputs& others,
              const RecordList& files);

    /// A sentence for each: "output.folders: 'HDMI-A-3' is not there, and …".
    const std::vector<std::string>& all() const { return faults_; }

  private:
    std::vector<std::string> faults_;
};

}  // namespace vitrine::player
