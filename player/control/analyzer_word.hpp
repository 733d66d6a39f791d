#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace vitrine::player {

/// The analyzer's status.json, cut into the pieces that answers need.
struct AnalyzerWord {
    std::string summary;  // a JSON object: no lists, but the number of files in each state
    std::map<std::string, std::string> entries;  // the JSON object of each file, by its path

    /// "" where the analyzer says nothing of the file.
    std::string entry(const std::string& path) const;
};

/// @param json  the content of status.json; anything else gives an empty word
AnalyzerWord analyzer_word_from(const std::string& json);

/// A file that cannot be read gives an empty word.
AnalyzerWord read_analyzer_word(const std::filesystem::path& file) noexcept;

/// Reads status.json on another thread whenever it has changed: with many files that takes longer than a
/// picture may, and so does forgetting the word before.
class AnalyzerWordReader {
  public:
    using Time = std::chrono::nanoseconds;
    using Read = std::function<AnalyzerWord(const std::filesystem::path&)>;

    /// @param read  called on another thread
    explicit AnalyzerWordReader(std::filesystem::path file, Read read = read_analyzer_word)
        : file_(std::move(file)), read_word_(std::move(read)) {}

    /// To be called at every tick; looks once a second. @param now  since the player's start
    void look(Time now);

    /// The newest word; empty where there is no analyzer, or it has left none.
    const AnalyzerWord& word() const { return word_; }

  private:
    using Version = std::pair<std::filesystem::file_time_type, std::uintmax_t>;

    void replace_word(AnalyzerWord word);

    std::filesystem::path file_;
    Read read_word_;
    AnalyzerWord word_;
    std::optional<Version> read_;  // the version of the file that was read, or is being read
    std::future<AnalyzerWord> reading_;
    std::future<void> forgetting_;  // the word before
    Time next_look_{0};
};

}  // namespace vitrine::player
