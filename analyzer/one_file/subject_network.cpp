#include "analyzer/one_file/subject_network.hpp"

#include "base/media/file_bytes.hpp"

#include <span>

namespace vitrine::analyzer {
namespace {

std::string bytes_of(const std::string& file) {
    const FileBytes source(file);
    std::string bytes(source.size(), '\0');
    bytes.resize(source.read(0, std::as_writable_bytes(std::span(bytes))));
    return bytes;
}

}  // namespace

std::unique_ptr<SaliencyNetwork> open_network(const std::string& file, int side) {
    const std::string model = bytes_of(file);
    const std::string smaller = with_input_side(model, side);
    if (smaller == model) return nullptr;
    return std::make_unique<SaliencyNetwork>(file, smaller, side);
}

SubjectNetwork::SubjectNetwork(const std::string& file)
    : full_(file), coarse_(open_network(file, coarse_side)) {}

SaliencyMap SubjectNetwork::find(const FramePair& pair) {
    SaliencyMap full = find_subject(full_, pair);
    if (!coarse_) return full;
    return (full + find_subject(*coarse_, pair)) / 2;
}

}  // namespace vitrine::analyzer
