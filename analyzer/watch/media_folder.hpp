#pragma once

#include "analyzer/watch/file_facts.hpp"
#include "base/system/unique_fd.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::analyzer {

/// True for names of files and folders that programs leave behind and nobody wants to see: hidden ones,
/// thumbnails, halves of downloads, wastebaskets, our own status folder.
bool is_junk_name(std::string_view name);

/// True for the names of files beside media that say something of them: is_keyframe_file(),
/// is_caption_file() and is_code_file().
bool is_sidecar(std::string_view name);

/// The folder whose photos and films are shown, as it is now. Links are skipped: none leads out of it. Paths
/// are relative to it, with '/' between folders and any bytes in names.
class MediaFolder {
  public:
    static constexpr int max_depth = 32;
    static constexpr std::size_t max_files = 100'000;
    static constexpr std::size_t max_inbox = 1000;

    /// @param passed_over  folders in it that are skipped: the status folder, our own state; relative to it
    explicit MediaFolder(std::filesystem::path root, std::vector<std::string> passed_over = {})
        : root_(std::move(root)), passed_over_(std::move(passed_over)) {}

    const std::filesystem::path& root() const { return root_; }

    std::filesystem::path absolute(const std::string& path) const { return root_ / path; }

    struct File {
        std::string path;
        FileFacts facts;
    };

    enum class Presence {
        there,
        gone,         // or no plain file, or junk
        unreachable,  // not known: a server that is off
    };

    struct LookResult {
        Presence presence = Presence::gone;
        File file;  // where it is there
    };

    /// Looks at one file.
    LookResult look_at(const std::string& path) const;

    struct Listing {
        std::vector<File> files;
        std::vector<std::string> sidecars;  // see is_sidecar(); they are no media
        std::vector<std::string> inbox;     // files that wait there to be moved out, at most max_inbox
        std::vector<std::string> unread;    // files and folders that could not be read
        std::vector<std::string> remarks;   // unreadable folders and exceeded limits, in plain words

        /// True where the path, or a folder that it lies in, could not be read.
        bool is_unread(const std::string& path) const;
    };

    using Enter = std::function<void(const std::string& folder)>;

    using Attend = std::function<void()>;

    /// All files in this folder ("" is the root) and below.
    /// @param enter  called with each folder before it is read, so that a watch set there misses nothing
    /// @param attend  called whenever a file or folder was found
    Listing list(const std::string& folder, const Enter& enter = {}, const Attend& attend = {}) const;

    /// The errno of looking at the root; 0 where it is a folder.
    int root_error() const;

    /// Identifies the file system that is mounted at the root; nothing where the root is missing.
    std::optional<std::uint64_t> device() const;

    /// True where other machines may change it unseen by this kernel: CIFS, NFS, FUSE, 9P.
    bool is_remote() const;

    /// True where the end of the file was never written: a copy that reserved its space first.
    bool ends_in_hole(const std::string& path) const;

    /// The first bytes of a plain file, also of one with a junk name; nothing where it cannot be read.
    std::optional<std::string> content(const std::string& path, std::size_t max_bytes) const;

  private:
    bool is_passed_over(const std::string& path) const;
    UniqueFd open(const std::string& path, int flags) const;

    std::filesystem::path root_;
    std::vector<std::string> passed_over_;
};

}  // namespace vitrine::analyzer
