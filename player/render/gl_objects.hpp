#pragma once

#include "base/geometry/vec2.hpp"
#include "player/render/view.hpp"

#include <GLES3/gl3.h>

#include <string>
#include <utility>

namespace vitrine::player {

/// The only owner of a GL object. Destroy it while its context is current. 0: no object.
template <void (*generate)(GLsizei, GLuint*), void (*destroy)(GLsizei, const GLuint*)> class GlObject {
  public:
    GlObject() { generate(1, &id_); }

    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }

    ~GlObject() {
        if (id_ != 0) destroy(1, &id_);
    }

    GLuint id() const { return id_; }

  private:
    GLuint id_ = 0;
};

using GlBuffer = GlObject<&glGenBuffers, &glDeleteBuffers>;
using GlTexture = GlObject<&glGenTextures, &glDeleteTextures>;
using GlVertexArray = GlObject<&glGenVertexArrays, &glDeleteVertexArrays>;

/// Throws std::runtime_error with GL's name of the first error since the last call, if there was one.
void check_gl(const char* what);

inline void set(GLint uniform, Vec2 value) {
    glUniform2f(uniform, static_cast<float>(value.x), static_cast<float>(value.y));
}

/// A compiled and linked pair of shaders (GLSL ES 3.00, without the #version line).
class GlProgram {
  public:
    /// @throws std::runtime_error with the compiler's message
    GlProgram(const char* vertex, const std::string& fragment);
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;
    GlProgram(GlProgram&&) = delete;
    GlProgram& operator=(GlProgram&&) = delete;
    ~GlProgram() = default;

    void use() const { glUseProgram(id_.value); }

    /// -1: the program does not use it; setting it then does nothing.
    GLint uniform(const char* name) const { return glGetUniformLocation(id_.value, name); }

  private:
    struct Id {
        GLuint value = glCreateProgram();

        Id() = default;
        Id(const Id&) = delete;
        Id& operator=(const Id&) = delete;
        Id(Id&&) = delete;
        Id& operator=(Id&&) = delete;

        ~Id() { glDeleteProgram(value); }
    };

    Id id_;
};

/// A program's uniforms for the place of the canvas: `uniform vec2 x_axis, y_axis, origin`.
struct ViewUniforms {
    explicit ViewUniforms(const GlProgram& program)
        : x_axis(program.uniform("x_axis")),
          y_axis(program.uniform("y_axis")),
          origin(program.uniform("origin")) {}

    /// @pre the program is in use
    void set(const ToNdc& view) const {
        vitrine::player::set(x_axis, view.x_axis);
        vitrine::player::set(y_axis, view.y_axis);
        vitrine::player::set(origin, view.origin);
    }

    GLint x_axis;
    GLint y_axis;
    GLint origin;
};

}  // namespace vitrine::player
