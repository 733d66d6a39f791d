#include "player/render/gl_objects.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace vitrine::player {

namespace {

const char* error_name(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "an unknown GL error";
    }
}

// Attaches a shader. It is deleted with its program.
void attach(GLuint program, GLenum type, const char* source) {
    const char* const lines[] = {"#version 300 es\n", source};
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 2, lines, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done) return;
    std::string words(1000, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), &length, words.data());
    words.resize(static_cast<std::size_t>(length));
    throw std::runtime_error(fmt::format("compile a shader: {}", words));
}

}  // namespace

void check_gl(const char* what) {
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("{}: {}", what, error_name(error)));
}

GlProgram::GlProgram(const char* vertex, const std::string& fragment) {
    attach(id_.value, GL_VERTEX_SHADER, vertex);
    attach(id_.value, GL_FRAGMENT_SHADER, fragment.c_str());
    glLinkProgram(id_.value);
    GLint done = 0;
    glGetProgramiv(id_.value, GL_LINK_STATUS, &done);
    if (!done) throw std::runtime_error("link the shaders: they do not match");
}

}  // namespace vitrine::player
