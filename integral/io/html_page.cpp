// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/html_page.h"

#include "integral/io/codecs.h"
#include "integral/io/markup.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

namespace integral {
namespace {

constexpr char page_style[] = R"css(
:root { color-scheme: light dark; --ground: #f6f6f4; --panel: #ffffff; --line: #d4d4d0; --text: #1b1c1e;
  --quiet: #5d6066;
        --good: #1a7136; --bad: #b3261e; --bad-ground: #fdecea; --mark: #8a5a00; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #18191b; --panel: #232528; --line: #3b3e43; --text: #e8e8e6; --quiet: #aeb1b6;
          --good: #6fcf8a; --bad: #ff8f85; --bad-ground: #43221f; --mark: #d9a441; }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--text); font: 15px/1.45 system-ui, sans-serif; }
main { max-width: 1240px; margin: 0 auto; padding: 16px; }
h1 { margin: 0 0 4px; font-size: 1.35rem; }
h2 { margin: 0 0 6px; font-size: 1.05rem; overflow-wrap: anywhere; }
p { margin: 0 0 10px; }
a { color: inherit; text-underline-offset: 2px; }
img { display: block; max-width: 100%; height: auto; background: #000; }
:focus-visible { outline: 2px solid var(--mark); outline-offset: 2px; }
.quiet { color: var(--quiet); }
.good { color: var(--good); }
.bad { color: var(--bad); }
section { background: var(--panel); border: 1px solid var(--line); border-radius: 6px; padding: 12px 16px;
  margin: 0 0 12px; }
table { border-collapse: collapse; width: 100%; background: var(--panel); border: 1px solid var(--line);
  margin: 0 0 16px; }
th, td { text-align: left; vertical-align: top; padding: 6px 10px; border-bottom: 1px solid var(--line);
  overflow-wrap: anywhere; }
th { font-weight: 600; color: var(--quiet); }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; overflow-wrap: normal; }
@media (max-width: 760px) {
  main { padding: 10px; }
  table.cards, table.cards tbody { display: block; border: 0; background: none; }
  table.cards thead { display: none; }
  table.cards tr { display: block; background: var(--panel); border: 1px solid var(--line);
    border-radius: 6px; margin: 0 0 8px; padding: 6px 0; }
  table.cards td { display: flex; justify-content: space-between; gap: 16px; text-align: right;
    padding: 2px 12px; border: 0; }
  table.cards td::before { content: attr(data-label); color: var(--quiet); text-align: left;
    white-space: nowrap; overflow-wrap: normal; }
}
)css";

} // namespace

Image scaled_down(const Image& picture, int longest, Scaling scaling)
{
    const double scale = std::min(1.0, double(longest) / std::max(picture.width, picture.height));
    const int width = std::max(1, int(std::lround(picture.width * scale))),
              height = std::max(1, int(std::lround(picture.height * scale)));
    Image small = make_image<std::uint8_t>(width, height, 3, Encoding{});
    const LinearReader light(picture);
    // Pixel x of the result is made from the columns edge(x) up to edge(x + 1) - 1.
    const auto edge = [](int x, int whole, int parts) {
        return int(std::int64_t(x) * whole / parts);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int x0 = edge(x, picture.width, width), x1 = edge(x + 1, picture.width, width);
            const int y0 = edge(y, picture.height, height),
                      y1 = edge(y + 1, picture.height, height);
            double sum[3] = {};
            Colour greatest = {0, 0, 0, 1};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u) {
                    const Colour c = light(u, v);
                    sum[0] += c.r;
                    sum[1] += c.g;
                    sum[2] += c.b;
                    greatest = {std::max(greatest.r, c.r), std::max(greatest.g, c.g),
                                std::max(greatest.b, c.b), 1};
                }
            const double count = double(x1 - x0) * (y1 - y0);
            store_linear(small, x, y,
                         scaling == Scaling::greatest
                             ? greatest
                             : Colour{float(sum[0] / count), float(sum[1] / count),
                                      float(sum[2] / count), 1});
        }
    return small;
}

std::string picture_uri(const Image& picture)
{
    DecodedImage file;
    file.image = picture;
    return "data:image/png;base64," + base64(encode_png(file));
}

std::string picture_element(const Image& picture, int longest, const std::string& text,
                            Scaling scaling)
{
    const Image small = scaled_down(picture, longest, scaling);
    return "<img src=\"" + picture_uri(small) + "\" width=\"" + std::to_string(small.width) +
           "\" height=\"" + std::to_string(small.height) + "\" alt=\"" + markup_text(text) + "\">";
}

std::string link_to(const std::string& path)
{
    constexpr char digits[] = "0123456789ABCDEF";
    std::string link = path.empty() || path[0] == '/' || path[0] == '.'
                           ? ""
                           : "./"; // a file name with a colon is not read as a URL scheme
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 &&
            (std::isalnum(byte) || c == '/' || c == '.' || c == '-' || c == '_' || c == '~'))
            link += c;
        else
            link += {'%', digits[byte >> 4], digits[byte & 15]};
    }
    return link;
}

std::string html_page(const std::string& title, const std::string& style, const std::string& body,
                      const PageScript& script)
{
    const bool runs = !script.text.empty();
    const std::string nonce = script.nonce.empty() ? "" : " nonce=\"" + script.nonce + "\"";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
           "'self' data:" +
           std::string(runs ? " blob:; script-src 'unsafe-inline'" : "") +
           "; style-src 'unsafe-inline'\">\n"
           "<title>" +
           markup_text(title) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style" + nonce +
           ">" + page_style + style + "</style>\n</head>\n<body>\n<main>\n" + body + "</main>\n" +
           (runs ? "<script" + nonce + ">\n" + script.text + "</script>\n" : "") +
           "</body>\n</html>\n";
}

} // namespace integral
