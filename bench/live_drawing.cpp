// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/live_drawing.h"

#include "integral/optics/lens_model.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace integral::bench {
namespace {

constexpr char covering_triangle[] = R"(#version 300 es
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); })";

constexpr int most_views = 32;        // max_views of live_view.glsl
constexpr float no_limit = 1e30f;     // of the aperture
constexpr float point_sized = 1e-30f; // half an extent of 0

EGLDisplay display_without_window()
{
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless") && platform_display)
        return platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

GLuint compiled(GLenum type, const std::string& text)
{
    const GLuint shader = glCreateShader(type);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    if (!is_compiled) {
        char log[4000] = "";
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        throw std::runtime_error(std::string("the driver refuses the shader: ") + log);
    }
    return shader;
}

/// Texels of `columns` (`axis` 0) or `rows`: view_steps of replay_drawing.js for the whole film.
std::vector<float> view_steps(const FrameMetadata& geometry, int axis, int count)
{
    const LensSheet& sheet = geometry.sheet;
    const Lattice lattice(sheet);
    const auto part = [axis](Vec2 v) { return axis == 0 ? v.x : v.y; };
    const int pixels = axis == 0 ? geometry.film.width : geometry.film.height;
    const double pitch = part(geometry.film.pixel_pitch), length = pixels * pitch;
    const double row_spacing = sheet.arrangement == Arrangement::hexagonal ? std::sqrt(3.0) / 2 : 1;
    std::vector<float> texels(8 * count);
    const auto put = [&](int at, double v) {
        texels[at] = float(std::floor(v));
        texels[at + 1] = float(v - std::floor(v));
    };
    for (int i = 0; i < count; ++i) {
        const double share = double(i) / count - 0.5, mm = (axis == 0 ? share : -share) * length;
        const double from_offset = mm - part(sheet.offset);
        put(4 * i, part(lattice.across()) * from_offset / sheet.pitch);
        put(4 * i + 2, part(lattice.along()) * from_offset / (sheet.pitch * row_spacing));
        put(4 * (count + i), (axis == 0 ? mm : -mm) / pitch + 0.5 * pixels);
        texels[4 * (count + i) + 2] = float(mm);
    }
    return texels;
}

void keep_texels(GLenum target)
{
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

} // namespace

/// Units of textures: columns, rows, the probe's colours, its nearness.
struct LiveDrawing::Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    GLuint program = 0, target = 0, steps[2] = {}, probe[2] = {};
    int width = 0, height = 0, views = 0;
    double probe_distance = 0;
    float max_nearness = 0;
    std::vector<float> eyes;
    FrameMetadata geometry;

    GLint at(const char* name) const { return glGetUniformLocation(program, name); }
    void number(const char* name, double v) const { glUniform1f(at(name), float(v)); }
    void whole(const char* name, int v) const { glUniform1i(at(name), v); }
    void pair(const char* name, Vec2 v) const { glUniform2f(at(name), float(v.x), float(v.y)); }
    void set_sheet() const;
};

LiveDrawing::LiveDrawing(const std::string& shader) : context_(std::make_unique<Context>())
{
    Context& c = *context_;
    c.display = display_without_window();
    if (c.display == EGL_NO_DISPLAY || !eglInitialize(c.display, nullptr, nullptr))
        throw std::runtime_error("there is no EGL display");
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint of_config[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                EGL_OPENGL_ES3_BIT, EGL_NONE};
    const EGLint of_context[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    const EGLint of_surface[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    EGLConfig config;
    EGLint number = 0;
    if (!eglChooseConfig(c.display, of_config, &config, 1, &number) || number < 1)
        throw std::runtime_error("this EGL has no OpenGL ES 3");
    const EGLContext context = eglCreateContext(c.display, config, EGL_NO_CONTEXT, of_context);
    const EGLSurface surface = eglCreatePbufferSurface(c.display, config, of_surface);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(c.display, surface, surface, context))
        throw std::runtime_error("this EGL opens no context of OpenGL ES 3");

    c.program = glCreateProgram();
    glAttachShader(c.program, compiled(GL_VERTEX_SHADER, covering_triangle));
    glAttachShader(c.program, compiled(GL_FRAGMENT_SHADER, shader.substr(shader.find('#'))));
    glLinkProgram(c.program);
    GLint linked = 0;
    glGetProgramiv(c.program, GL_LINK_STATUS, &linked);
    if (!linked)
        throw std::runtime_error("the driver does not link the shader");
    glUseProgram(c.program);
    glGenTextures(2, c.steps);
    glGenTextures(2, c.probe);
    const char* const units[] = {"columns", "rows", "colours", "nearness"};
    for (int unit = 0; unit < 4; ++unit)
        c.whole(units[unit], unit);
}

LiveDrawing::~LiveDrawing() { eglTerminate(context_->display); }

std::string LiveDrawing::renderer() const
{
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

void LiveDrawing::set_probe(const Probe& probe)
{
    Context& c = *context_;
    c.probe_distance = probe.sheet_distance;
    c.views = int(probe.views.size());
    if (c.views < 1 || c.views > most_views)
        throw std::invalid_argument("a probe has 1 to 32 views");
    glDeleteTextures(2, c.probe);
    glGenTextures(2, c.probe);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const GLenum formats[] = {GL_SRGB8, GL_R32F};
    for (int k = 0; k < 2; ++k) {
        glActiveTexture(GL_TEXTURE2 + k);
        glBindTexture(GL_TEXTURE_2D_ARRAY, c.probe[k]);
        glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, formats[k], probe.width, probe.height, c.views);
        keep_texels(GL_TEXTURE_2D_ARRAY);
    }
    c.eyes.clear();
    c.max_nearness = 0;
    for (int view = 0; view < c.views; ++view) {
        const ProbeView& v = probe.views[view];
        std::vector<float> relative;
        for (const float nearness : v.nearness)
            relative.push_back(float(nearness * probe.sheet_distance));
        c.max_nearness = std::max(c.max_nearness,
                                  *std::max_element(relative.begin(), relative.end()));
        c.eyes.push_back(float(v.eye.x / probe.sheet_distance));
        c.eyes.push_back(float(v.eye.y / probe.sheet_distance));
        glActiveTexture(GL_TEXTURE2);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, view, probe.width, probe.height, 1, GL_RGB,
                        GL_UNSIGNED_BYTE, v.colours.data());
        glActiveTexture(GL_TEXTURE3);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, view, probe.width, probe.height, 1, GL_RED,
                        GL_FLOAT, relative.data());
    }
}

/// Uniforms that do not change with the eye.
void LiveDrawing::Context::set_sheet() const
{
    const LensSheet& sheet = geometry.sheet;
    const Film& film = geometry.film;
    const Aperture& aperture = geometry.aperture;
    const Lattice lattice(sheet);
    const LensModel model = geometry.render ? geometry.render->model : LensModel::extended_pinhole;
    const double ior = modelled_sheet(sheet, model).ior;
    whole("arrangement", int(sheet.arrangement));
    whole("subpixels", film.subpixels == Subpixels::rgb   ? 1
                       : film.subpixels == Subpixels::bgr ? 2
                                                          : 0);
    glUniform2i(at("film_size"), film.width, film.height);
    pair("pixel_pitch", film.pixel_pitch);
    number("pitch", sheet.pitch);
    number("row_spacing", sheet.arrangement == Arrangement::hexagonal ? std::sqrt(3.0) / 2 : 1);
    pair("across", lattice.across());
    pair("along", lattice.along());
    pair("centre_to_lens", {dot(lattice.across(), sheet.offset) / sheet.pitch,
                            dot(lattice.along(), sheet.offset) / sheet.pitch});
    number("thickness", sheet.thickness);
    number("n_squared", ior * ior);
    number("m", (ior - 1) * (ior + 1));
    pair("view_pixel",
         {film.width * film.pixel_pitch.x / width, film.height * film.pixel_pitch.y / height});
    whole("view_height", height);
    const auto half = [](double mm) {
        return std::isinf(mm) ? no_limit : std::max(0.5f * float(mm), point_sized);
    };
    number("aperture_distance", aperture.distance);
    glUniform2f(at("aperture_half"), half(aperture.width), half(aperture.height));
    whole("elliptical", aperture.shape == ApertureShape::ellipse);
    whole("upright_slit", !slit_is_horizontal(sheet));
}

void LiveDrawing::set_view(int width, int height, const FrameMetadata& geometry)
{
    Context& c = *context_;
    if (width != c.width || height != c.height) {
        if (c.target)
            glDeleteFramebuffers(1, &c.target);
        GLuint buffer;
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
        glGenFramebuffers(1, &c.target);
        glBindFramebuffer(GL_FRAMEBUFFER, c.target);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("no picture of this size can be drawn");
    }
    c.width = width;
    c.height = height;
    c.geometry = geometry;
    for (int axis = 0; axis < 2; ++axis) {
        const int count = axis == 0 ? width : height;
        glActiveTexture(GL_TEXTURE0 + axis);
        glBindTexture(GL_TEXTURE_2D, c.steps[axis]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, 2, 0, GL_RGBA, GL_FLOAT,
                     view_steps(geometry, axis, count).data());
        keep_texels(GL_TEXTURE_2D);
    }
    c.set_sheet();
}

void LiveDrawing::draw(Eye eye, const LivePlacement& placement, const LiveOptions& options)
{
    const Context& c = *context_;
    c.pair("eye", {eye.x, eye.y});
    c.number("eye_distance", eye.distance);
    c.number("sheet_distance", placement.sheet_distance);
    c.number("scene_distance", placement.scene_distance);
    c.number("parallax", placement.parallax);
    c.number("tint", options.tint);
    c.whole("samples", options.samples);
    c.whole("max_steps", options.steps);
    c.whole("without_sheet", options.without_sheet);
    c.whole("view_count", c.views);
    glUniform2fv(c.at("view_eyes"), c.views, c.eyes.data());
    c.number("probe_distance", c.probe_distance);
    c.number("max_nearness", c.max_nearness);
    glViewport(0, 0, c.width, c.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
}

Image LiveDrawing::picture() const
{
    const Context& c = *context_;
    std::vector<std::uint8_t> pixels(std::size_t(4) * c.width * c.height);
    glReadPixels(0, 0, c.width, c.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    if (const GLenum error = glGetError())
        throw std::runtime_error("OpenGL error " + std::to_string(error));
    Image image = make_image<std::uint8_t>(c.width, c.height, 3, Encoding());
    auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
    for (int y = 0; y < c.height; ++y)
        for (int x = 0; x < c.width; ++x)
            std::copy_n(&pixels[4 * (std::size_t(c.height - 1 - y) * c.width + x)], 3,
                        &samples[3 * (std::size_t(y) * c.width + x)]);
    return image;
}

} // namespace integral::bench
