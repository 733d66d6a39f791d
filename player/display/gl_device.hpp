#pragma once

#include <GLES3/gl3.h>

#include <string>
#include <string_view>

namespace vitrine::player {

/// GL's own name of the renderer of the current context.
inline std::string gl_device() {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "unknown renderer";
}

/// True if this name belongs to a renderer on the processor, not on a graphics card.
inline bool is_software(std::string_view device) {
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "swrast", "Software"})
        if (device.find(name) != std::string_view::npos) return true;
    return false;
}

/// True if this word is in a list of words, as EGL and GL list their extensions.
inline bool has_word(const char* words, std::string_view word) {
    for (std::string_view rest = words ? words : ""; !rest.empty();) {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == word) return true;
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return false;
}

}  // namespace vitrine::player
