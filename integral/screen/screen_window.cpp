// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/screen/screen_window.h"

#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"
#include "integral/io/release.h"

#ifdef HAVE_SDL2
#include <SDL.h>
#endif

#include <thread>

namespace integral {

#ifdef HAVE_SDL2

namespace {

using Clock = std::chrono::steady_clock;

} // namespace

struct ScreenWindow::Parts {
    std::unique_ptr<SDL_Window, Release<SDL_Window, SDL_DestroyWindow>> window;
    std::unique_ptr<SDL_Renderer, Release<SDL_Renderer, SDL_DestroyRenderer>> renderer;
    std::unique_ptr<SDL_Texture, Release<SDL_Texture, SDL_DestroyTexture>> texture;
    bool has_picture = false;

    /// Width and height of SDL's drawing area, pixels.
    std::pair<int, int> drawn_size() const
    {
        int width = 0, height = 0;
        SDL_GetRendererOutputSize(renderer.get(), &width, &height);
        return {width, height};
    }
};

ScreenWindow::ScreenWindow(const Screen& screen, const std::string& name)
    : screen_(screen), name_(name), parts_(std::make_unique<Parts>())
{
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    const int at = int(SDL_WINDOWPOS_UNDEFINED_DISPLAY(screen.index));
    parts_->window.reset(SDL_CreateWindow("integral lcd", at, at, screen.width, screen.height,
                                          SDL_WINDOW_BORDERLESS | SDL_WINDOW_FULLSCREEN_DESKTOP |
                                              SDL_WINDOW_ALLOW_HIGHDPI));
    // Tries a renderer synchronised with the display's refresh first, then one without
    // synchronisation, then one in software.
    for (const Uint32 flags :
         {SDL_RENDERER_PRESENTVSYNC, SDL_RendererFlags(0), SDL_RENDERER_SOFTWARE}) {
        if (!parts_->window || parts_->texture)
            break;
        parts_->renderer.reset();
        parts_->renderer.reset(SDL_CreateRenderer(parts_->window.get(), -1, flags));
        if (parts_->renderer)
            parts_->texture.reset(
                SDL_CreateTexture(parts_->renderer.get(), SDL_PIXELFORMAT_ARGB8888,
                                  SDL_TEXTUREACCESS_STREAMING, screen.width, screen.height));
    }
    if (!parts_->texture)
        throw OutputError(name_ + ": no window can be opened (" + SDL_GetError() + ")");
    SDL_SetTextureBlendMode(parts_->texture.get(), SDL_BLENDMODE_NONE);
    const Uint32 format = SDL_GetWindowPixelFormat(parts_->window.get());
    int bits = 0;
    Uint32 red = 0, green = 0, blue = 0, alpha = 0;
    SDL_PixelFormatEnumToMasks(format, &bits, &red, &green, &blue, &alpha);
    const auto width_of = [](Uint32 mask) { return __builtin_popcount(mask); };
    if (width_of(red) < 8 || width_of(green) < 8 || width_of(blue) < 8)
        throw OutputError(name_ + ": it shows " + std::to_string(SDL_BITSPERPIXEL(format)) +
                          " bits a pixel, and pictures have 24; set the desktop to that");
    SDL_DisableScreenSaver();
    SDL_ShowCursor(SDL_DISABLE);
    settle();
}

ScreenWindow::~ScreenWindow()
{
    SDL_ShowCursor(SDL_ENABLE);
    SDL_EnableScreenSaver();
}

/// Waits until the desktop has given the window its place and size.
void ScreenWindow::settle()
{
    const auto last = Clock::now() + std::chrono::seconds(2);
    for (;;) {
        SDL_PumpEvents();
        SDL_RenderClear(parts_->renderer.get());
        SDL_RenderPresent(parts_->renderer.get());
        int x = 0, y = 0;
        SDL_GetWindowPosition(parts_->window.get(), &x, &y);
        const auto [width, height] = parts_->drawn_size();
        const bool has_size = width == screen_.width && height == screen_.height;
        if (has_size && x == screen_.x && y == screen_.y)
            break;
        if (Clock::now() > last)
            throw OutputError(name_ + ": " +
                              (has_size
                                   ? "the desktop puts the window elsewhere; end what keeps "
                                     "windows off that display"
                                   : "the desktop gives the window " + size_text(width, height) +
                                         " pixels in place of the display's " +
                                         size_text(screen_.width, screen_.height) +
                                         "; set its scale to 100%"));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    // Events from opening the window must not count as changes of the display's size.
    SDL_FlushEvents(SDL_WINDOWEVENT, SDL_WINDOWEVENT);
}

void ScreenWindow::draw()
{
    SDL_RenderClear(parts_->renderer.get());
    SDL_RenderCopy(parts_->renderer.get(), parts_->texture.get(), nullptr, nullptr);
}

void ScreenWindow::read_back(const ScreenPicture& picture)
{
    std::vector<std::uint32_t> drawn(picture.pixels.size());
    if (SDL_RenderReadPixels(parts_->renderer.get(), nullptr, SDL_PIXELFORMAT_ARGB8888,
                             drawn.data(), 4 * picture.width) != 0)
        throw OutputError(name_ + ": what it shows cannot be read back (" + SDL_GetError() + ")");
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k)
        wrong += ((drawn[k] ^ picture.pixels[k]) & 0xffffff) != 0;
    if (wrong)
        throw OutputError(name_ + ": its driver draws " + std::to_string(wrong) +
                          " pixels with wrong colours; SDL_RENDER_DRIVER=software may help");
}

void ScreenWindow::show(const ScreenPicture& picture)
{
    if (SDL_UpdateTexture(parts_->texture.get(), nullptr, picture.pixels.data(),
                          4 * picture.width) != 0)
        throw OutputError(name_ + ": the picture cannot be drawn (" + SDL_GetError() + ")");
    draw();
    if (!parts_->has_picture)
        read_back(picture);
    parts_->has_picture = true;
    SDL_RenderPresent(parts_->renderer.get());
}

Wish ScreenWindow::wait(std::chrono::nanoseconds longest)
{
    const auto until = Clock::now() + longest;
    SDL_Event event;
    for (;;) {
        while (SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT ||
                (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_CLOSE))
                return Wish::end;
            if (event.type == SDL_KEYDOWN && event.key.repeat == 0) {
                if (event.key.keysym.sym == SDLK_ESCAPE || event.key.keysym.sym == SDLK_q)
                    return Wish::end;
                if (event.key.keysym.sym == SDLK_SPACE)
                    return Wish::pause;
            }
            if (parts_->drawn_size() != std::pair(screen_.width, screen_.height))
                throw OutputError(
                    name_ + ": its size has changed, and the picture would be scaled; start again");
            const bool redraw = event.type == SDL_RENDER_TARGETS_RESET ||
                                (event.type == SDL_WINDOWEVENT &&
                                 event.window.event == SDL_WINDOWEVENT_EXPOSED);
            if (redraw && parts_->has_picture) {
                draw();
                SDL_RenderPresent(parts_->renderer.get());
            }
        }
        // SDL waits for whole milliseconds only; a sleep takes the remaining time.
        const auto left = until - Clock::now();
        if (left <= std::chrono::nanoseconds(0))
            return Wish::none;
        const auto whole = std::chrono::duration_cast<std::chrono::milliseconds>(left).count() - 1;
        if (whole > 0)
            SDL_WaitEventTimeout(nullptr, int(whole));
        else
            std::this_thread::sleep_until(until);
    }
}

#else

struct ScreenWindow::Parts {};
ScreenWindow::ScreenWindow(const Screen& screen, const std::string& name)
    : screen_(screen), name_(name)
{
    throw OutputError(name + ": this program was built without SDL2");
}
ScreenWindow::~ScreenWindow() = default;
void ScreenWindow::show(const ScreenPicture&) {}
Wish ScreenWindow::wait(std::chrono::nanoseconds) { return Wish::end; }

#endif

} // namespace integral
