#include "analyzer/models/face_model.hpp"

#include "base/settings/settings.hpp"

#include <filesystem>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

std::string find_face_model(const std::string& wanted) {
    if (wanted != Settings{}.analyzer.face_model) return wanted;
    const fs::path program = fs::read_symlink("/proc/self/exe");
    const fs::path beside =
        program.parent_path().parent_path() / "share/vitrine" / fs::path(wanted).filename();
    return fs::exists(beside) ? beside.string() : std::string();
}

}  // namespace vitrine::analyzer
