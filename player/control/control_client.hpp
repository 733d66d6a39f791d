#pragma once

#include "player/display/picture.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

struct sd_bus;

namespace vitrine::player {

/// Why the player did not do what it was asked.
class ControlError : public std::runtime_error {
  public:
    enum class Kind { failed, not_allowed, not_running };

    ControlError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}

    Kind kind() const { return kind_; }

  private:
    Kind kind_;
};

/// The player, asked over the system bus. Every call waits for its answer. @throws ControlError
class ControlClient {
  public:
    struct Shot {
        std::string output;
        Picture picture;
    };

    ControlClient();

    std::string status();                      // JSON
    std::string why(const std::string& file);  // JSON
    std::vector<Shot> screenshot();
    void next();
    void pause(bool is_on);
    std::string pin(const std::string& file, bool is_on);  // what the file is called in the media folder
    void pin_slot(unsigned slot, bool is_on);
    std::string remove(const std::string& file);
    void reload();

  private:
    class Call;

    struct Unref {
        void operator()(sd_bus* bus) const;
    };

    std::unique_ptr<sd_bus, Unref> bus_;
};

}  // namespace vitrine::player
