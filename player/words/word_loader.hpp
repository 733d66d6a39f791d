#pragma once

#include "player/words/word_item.hpp"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace vitrine::player {

/// The picture of a text that was asked for.
struct LoadedWord {
    std::string text;
    std::shared_ptr<const WordPicture> picture;
};

/// Reads the picture of a text from its file. @return  none: there is no such file, or it is no such picture
std::shared_ptr<const WordPicture> load_word(const std::filesystem::path& file);

/// Thread-safe. Reads the pictures of words on a thread of its own, so that no frame waits for one. A picture
/// that the analyzer has not set yet is looked for again.
class WordLoader {
  public:
    /// @param state  the state directory
    /// @param rest   time between two looks for the pictures that are not there
    explicit WordLoader(std::filesystem::path state,
                        std::chrono::milliseconds rest = std::chrono::seconds(2));
    WordLoader(const WordLoader&) = delete;
    WordLoader& operator=(const WordLoader&) = delete;
    WordLoader(WordLoader&&) = delete;
    WordLoader& operator=(WordLoader&&) = delete;
    ~WordLoader();

    /// Asks for the pictures of these texts. They replace all that were asked for before.
    void want(std::set<std::string> texts);

    /// Takes the pictures that have been read since the last call. A text is read again only if it was not
    /// wanted in between.
    std::vector<LoadedWord> take();

  private:
    void run();
    std::vector<LoadedWord> read(const std::vector<std::string>& texts) const;

    const std::filesystem::path state_;
    const std::chrono::milliseconds rest_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::set<std::string> wanted_;    // guarded by mutex_
    std::set<std::string> known_;     // guarded by mutex_; those of wanted_ that were read
    std::vector<LoadedWord> loaded_;  // guarded by mutex_
    bool is_stopping_ = false;        // guarded by mutex_
    bool has_news_ = false;           // guarded by mutex_; wanted_ has new texts
    std::thread thread_;              // last: it uses all members above
};

}  // namespace vitrine::player
