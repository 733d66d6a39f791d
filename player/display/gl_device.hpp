#pragma once

#include <GLES3/gl3.h>

#include <string>
#include <string_view>

namespace vitrine {

/// GL's own name for what draws in the current context.
inline std::string gl_device() {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "unknown renderer";
}

/// Whether that is the processor and not a graphics card.
inline bool is_software(std::string_view device) {
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "swrast", "Software"})
        if (device.find(name) != std::string_view::npos) return true;
    return false;
}

}  // namespace vitrine
