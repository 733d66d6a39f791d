#pragma once

#include "base/state/record.hpp"

#include <cstddef>
#include <optional>

namespace vitrine::analyzer {

/// The shots of one film that are known while its analysis goes on. Pure: FileBook decides when they are
/// written.
///
/// A second try begins at the film's first shot again. Until it knows more shots than the first try, the
/// catalogue keeps those of the first.
class FilmGrowth {
  public:
    /// @param file  path and content; nothing is published of it
    explicit FilmGrowth(const MediaRecord& file) : record_(file) {}

    /// A growth that the catalogue has already: `record` with all its shots.
    static FilmGrowth published(const MediaRecord& record);

    /// An analysis begins of the content that `file` names.
    void begin_analysis(const MediaRecord& file);

    /// Adds new shots, or replaces earlier ones that begin at the same time.
    /// @param part  its path, bytes and mtime are those of begin_analysis()
    void add_shots(const MediaRecord& part);

    /// The record, where it has more than the catalogue; each addition is returned once.
    std::optional<MediaRecord> take_news();

  private:
    MediaRecord record_;
    std::size_t published_ = 0;  // shots that the catalogue has of this content
    bool is_changed_ = false;    // a published shot has been replaced
};

}  // namespace vitrine::analyzer
