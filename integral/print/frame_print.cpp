// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/frame_print.h"

#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/frame/names.h"
#include "integral/io/picture_series.h"
#include "integral/print/page_pdf.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <type_traits>

namespace integral {
namespace {

/// The time now, or the time in SOURCE_DATE_EPOCH.
std::time_t time_of_print()
{
    constexpr long long last = 253402300799; // of the year 9999
    const char* fixed = std::getenv("SOURCE_DATE_EPOCH");
    if (!fixed)
        return std::time(nullptr);
    char* end = nullptr;
    const long long seconds = std::strtoll(fixed, &end, 10);
    if (end == fixed || *end || seconds < 0 || seconds > last)
        throw std::invalid_argument("SOURCE_DATE_EPOCH is no time that has a date; give seconds "
                                    "from 1970 on, to the year 9999");
    return std::time_t(seconds);
}

std::string today()
{
    const std::time_t now = time_of_print();
    std::tm day;
    char text[40];
    if (!gmtime_r(&now, &day) || std::strftime(text, sizeof text, "%Y-%m-%d", &day) == 0)
        throw std::invalid_argument("SOURCE_DATE_EPOCH is no time that has a date");
    return text;
}

/// Returns work(). Passes on InputError, OutputError and Interrupted, which name the file or the
/// cause; converts other errors of type `Other` by `named`.
template <class Other, class Work, class Named> auto with_errors_named(Work work, Named named)
{
    try {
        return work();
    } catch (const InputError&) {
        throw;
    } catch (const OutputError&) {
        throw;
    } catch (const Interrupted&) {
        throw;
    } catch (const Other& error) {
        throw named(error);
    }
}

/// Returns draw(), which draws a page; adds the page's size to errors.
template <class Draw> auto drawn(const Page& page, Draw draw)
{
    return with_errors_named<std::runtime_error>(draw, [&](const std::runtime_error& error) {
        return std::invalid_argument("a page of " + std::to_string(page.width) + " x " +
                                     std::to_string(page.height) + " pixels: " + error.what());
    });
}

/// Adds white ink to a picture in four inks: everywhere, or as far as the picture as stored is
/// opaque.
Image with_white_ink(const Image& inks, const Image& stored, WhiteInk white)
{
    Image all = blank_like(form_of(sample_bits(inks), 0, 0, 5, inks.encoding), inks.width,
                           inks.height);
    std::visit(
        [&](auto& to) {
            using Row = std::decay_t<decltype(to)>;
            using Sample = typename Row::value_type;
            const Row& from = std::get<Row>(inks.samples);
            const float full = sample_bits(inks) == 8 ? 255.0f : 65535.0f;
            for_each_row(inks.height, 0, [&](int y) {
                for (int x = 0; x < inks.width; ++x) {
                    const std::size_t pixel = std::size_t(y) * inks.width + x;
                    std::copy_n(&from[4 * pixel], 4, &to[5 * pixel]);
                    const float opaque = white == WhiteInk::full ? 1 : stored_pixel(stored, x, y).a;
                    to[5 * pixel + 4] = Sample(std::clamp(opaque, 0.0f, 1.0f) * full + 0.5f);
                }
            });
        },
        all.samples);
    return all;
}

} // namespace

PageFormat page_format(const std::string& path)
{
    if (path == "-")
        return PageFormat::png;
    const std::string extension = extension_of(path);
    if (extension == "pdf")
        return PageFormat::pdf;
    if (extension == "tif" || extension == "tiff")
        return PageFormat::tiff;
    if (extension == "png")
        return PageFormat::png;
    throw OutputError(path + ": pages are .pdf, .tiff or .png");
}

std::string print_title(const std::string& path, const FrameMetadata& m)
{
    const auto slash = path.rfind('/');
    std::string text = m.render && !m.render->scene.empty()
                           ? m.render->scene
                           : path.substr(slash == std::string::npos ? 0 : slash + 1);
    text += std::string(", ") + name_of(m.sheet.arrangement) + " " + with_digits(m.sheet.pitch, 6) +
            " mm, " + with_digits(m.sheet.thickness, 6) + " mm thick, ior " +
            with_digits(m.sheet.ior, 6);
    if (m.sheet.slant != 0)
        text += ", slant " + with_digits(m.sheet.slant, 6);
    text += ", " + with_digits(mm_per_inch / m.film.pixel_pitch.x, 6) + " x " +
            with_digits(mm_per_inch / m.film.pixel_pitch.y, 6) + " dpi, from " +
            with_digits(m.aperture.distance, 6) + " mm, " + today();
    if (m.render && m.render->error)
        text += ", error " + with_digits(m.render->error->rms, 6);
    return text;
}

Vec2 printer_pitch(const Film& film, Vec2 feed, const std::optional<Vec2>& dpi)
{
    const Vec2 made{film.pixel_pitch.x / feed.x, film.pixel_pitch.y / feed.y};
    if (!dpi)
        return made;
    const auto differs = [](double a, double b) { return std::fabs(a - b) > 1e-6 * b; };
    if (differs(mm_per_inch / made.x, dpi->x) || differs(mm_per_inch / made.y, dpi->y)) {
        const Vec2 pitch{mm_per_inch / dpi->x * feed.x, mm_per_inch / dpi->y * feed.y};
        throw std::invalid_argument(
            "the frame has " + with_digits(mm_per_inch / film.pixel_pitch.x, 6) + " x " +
            with_digits(mm_per_inch / film.pixel_pitch.y, 6) +
            " pixels an inch, and is never resampled; for this printer render it with film { "
            "pixel_pitch <" +
            with_digits(pitch.x, 6) + ", " + with_digits(pitch.y, 6) +
            "> }, or let it print at the frame's own resolution");
    }
    return {mm_per_inch / dpi->x, mm_per_inch / dpi->y};
}

Image over_white(Image picture, int bits)
{
    const Encoding srgb;
    if (picture.channels == 1) {
        Image page = blank_like(form_of(bits, picture.width, picture.height, 3, picture.encoding),
                                picture.width, picture.height);
        for_each_row(picture.height, 0, [&](int y) {
            for (int x = 0; x < picture.width; ++x)
                store_pixel(page, x, y, stored_pixel(picture, x, y));
        });
        return page;
    }
    if (picture.channels == 3)
        return sample_bits(picture) == bits && same_encoding(picture.encoding, srgb)
                   ? std::move(picture)
                   : converted(picture, bits, srgb, false);
    Image page = blank_like(form_of(bits, picture.width, picture.height, 3, srgb), picture.width,
                            picture.height);
    const LinearReader light(picture);
    for_each_row(picture.height, 0, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            const Colour c = light(x, y);
            store_linear(page, x, y, {c.r + 1 - c.a, c.g + 1 - c.a, c.b + 1 - c.a, 1});
        }
    });
    return page;
}

FramePrint::FramePrint(FrameReader& frame, const PrintSettings& settings)
    : FramePrint({&frame}, *frame.frame().metadata, settings)
{
}

FramePrint::FramePrint(const std::vector<FrameReader*>& frames, const FrameMetadata& geometry,
                       const PrintSettings& settings)
    : geometry_(geometry), pixel_pitch_(settings.pixel_pitch), title_(settings.title)
{
    pages_ = lay_out(geometry, pixel_pitch_, settings.page);
    const Film& film = geometry.film;
    int bits = settings.bits;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const auto& placed = settings.page.frames;
        const PixelRectangle place = placed.empty() ? PixelRectangle{0, 0, film.width, film.height}
                                                    : placed.at(k).place;
        const auto same = std::find_if(sources_.begin(), sources_.end(), [&](const Source& source) {
            return source.frame->reader == frames[k];
        });
        if (same != sources_.end()) {
            sources_.push_back({same->frame, place});
        } else {
            sources_.push_back({std::make_shared<FrameRows>(), place});
            sources_.back().frame->reader = frames[k];
            if (settings.halftone)
                sources_.back().frame->halftone.emplace(*frames[k]->frame().metadata,
                                                        *settings.halftone);
        }
        if (settings.bits == 0)
            bits = std::max(bits, std::min(16, sample_bits(frames[k]->frame().image)));
    }
    form_ = form_of(bits, film.width, film.height, 3, Encoding());
    profile_ = srgb_profile();
    if (settings.halftone) {
        levels_ = settings.halftone->levels;
        form_ = form_of(8, film.width, film.height, settings.halftone->grey ? 1 : 3, Encoding());
        return;
    }
    if (!settings.profile)
        return;
    profile_ = read_file(*settings.profile);
    try {
        transform_.emplace(profile_, bits, settings.intent);
    } catch (const std::runtime_error& error) {
        throw InputError(*settings.profile + ": " + error.what());
    }
    form_.channels = transform_->channels();
    if (settings.page.white == WhiteInk::none)
        return;
    if (form_.channels == 3)
        throw InputError(*settings.profile +
                         ": it is an RGB profile; white ink needs that of a CMYK press");
    form_.channels = 5;
}

bool FramePrint::is_two_tone() const { return levels_ == 2; }

/// The frame's next rows.
Image FramePrint::FrameRows::read(int rows)
{
    const Image& frame = reader->frame().image;
    stop_if_interrupted();
    Image read_rows = blank_like(frame, frame.width, rows);
    reader->read(read_rows);
    next += rows;
    return read_rows;
}

/// Rows of a frame, halftoned in the blocks that the halftone requires.
Image FramePrint::halftoned_rows(FrameRows& frame, int first, int count)
{
    Image& block = frame.block;
    if (first < frame.next - block.height) {
        frame.reader->restart();
        frame.halftone->restart();
        frame.next = 0;
        block = Image();
    }
    const int width = frame.reader->frame().image.width,
              height = frame.reader->frame().image.height;
    Image picture = blank_like(form_, width, count);
    for (int y = first; y < first + count; ++y) {
        while (y >= frame.next) {
            Image rows = frame.read(std::min(LensHalftone::block_rows, height - frame.next));
            block = frame.halftone->apply(rows.channels == 3 ? rows
                                                             : over_white(std::move(rows), 16));
        }
        std::memcpy(row_bytes(picture, y - first),
                    row_bytes(block, y - (frame.next - block.height)),
                    std::size_t(width) * form_.channels);
    }
    return picture;
}

/// Rows of a frame in the profile's colours, or halftoned. Going back reads the file from its start
/// again.
Image FramePrint::new_rows_of_frame(FrameRows& frame, int first, int count)
{
    if (frame.halftone)
        return halftoned_rows(frame, first, count);
    if (first < frame.next) {
        frame.reader->restart();
        frame.next = 0;
    }
    while (frame.next < first)
        frame.read(std::min(rows_of_a_band(frame.reader->frame().image), first - frame.next));
    const Image stored = frame.read(count);
    Image picture = over_white(stored, sample_bits(form_));
    if (transform_)
        picture = transform_->apply(std::move(picture));
    return form_.channels == 5 ? with_white_ink(picture, stored, pages_[0].white) : picture;
}

/// The same; the last rows are kept, for copies of the frame beside it.
const Image& FramePrint::rows_of_frame(FrameRows& frame, int first, int count)
{
    if (frame.band_row != first || frame.band.height != count) {
        frame.band = new_rows_of_frame(frame, first, count);
        frame.band_row = first;
    }
    return frame.band;
}

/// Rows of the picture: the frames with paper between them.
Image FramePrint::rows(int first, int count)
{
    const PixelRectangle& only = sources_[0].place;
    if (sources_.size() == 1 && only.width == form_.width && only.height == form_.height)
        return new_rows_of_frame(*sources_[0].frame, first, count);
    Image band = blank_like(form_, form_.width, count);
    fill_with_paper(band, pages_[0].white);
    const std::size_t pixel = std::size_t(form_.channels) * (sample_bits(form_) / 8);
    for (Source& source : sources_) {
        const PixelRectangle& place = source.place;
        const int begin = std::max(first, place.y),
                  end = std::min(first + count, place.y + place.height);
        if (begin >= end)
            continue;
        const Image& part = rows_of_frame(*source.frame, begin - place.y, end - begin);
        for (int y = 0; y < part.height; ++y)
            std::memcpy(row_bytes(band, begin - first + y) + pixel * place.x, row_bytes(part, y),
                        pixel * part.width);
    }
    return band;
}

std::vector<std::string> FramePrint::inks() const
{
    if (form_.channels <= 3)
        return {};
    std::vector<std::string> inks = {"Cyan", "Magenta", "Yellow", "Black", "White"};
    inks.resize(std::size_t(form_.channels));
    return inks;
}

PictureRows FramePrint::row_source()
{
    return [this](int first, int count) { return rows(first, count); };
}

/// Opens the file of a page, with its geometry if the page can be replayed.
PictureWriter FramePrint::page_writer(const Page& page, const std::string& path) const
{
    std::optional<FrameMetadata> geometry;
    if (const auto g = geometry_of(page, geometry_)) {
        geometry = g->metadata;
        geometry->encoding = Encoding();
    }
    Image form = form_;
    form.width = page.width;
    form.height = page.height;
    if (form.channels == 1)
        return PictureWriter::of_grey_page(path, form, pixel_pitch_, is_two_tone(), geometry);
    return PictureWriter::of_page(path, form, pixel_pitch_, profile_, geometry, inks());
}

void FramePrint::write_pdf_file(const std::string& path)
{
    constexpr double longest = 14400 * mm_per_inch / 72; // mm: PDF 1.6, annex C
    for (const Page& page : pages_)
        if (std::max(page.width * page.pixel_pitch.x, page.height * page.pixel_pitch.y) > longest)
            throw OutputError(path + ": a page of a PDF is at most 5080 mm long; write a .tiff, or "
                                     "print fewer frames");
    OutputFile file(path);
    with_errors_named<std::exception>(
        [&] {
            write_pdf(file, pages_, form_, row_source(), profile_, title_, time_of_print(),
                      is_two_tone());
        },
        [&](const std::exception& error) { return OutputError(path + ": " + reason_of(error)); });
    file.finish();
}

void FramePrint::write_pictures(const std::string& path, const Progress& progress)
{
    const int count = page_count();
    for (int begin = 0; begin < count;) { // a row of tiles
        const int end = begin + pages_[std::size_t(begin)].columns;
        const std::vector<Page> pages(pages_.begin() + begin, pages_.begin() + end);
        std::vector<PictureWriter> files;
        for (int k = begin; k < end; ++k)
            files.push_back(page_writer(pages_[std::size_t(k)],
                                        count == 1 ? path : numbered(path, k + 1, count)));
        drawn(pages[0], [&] {
            draw_pages(pages, form_, row_source(), [&](std::size_t k, const Image& rows) {
                stop_if_interrupted();
                files[k].write(rows);
            });
        });
        for (PictureWriter& file : files)
            file.finish();
        begin = end;
        if (progress && !progress(begin, count) && begin < count)
            throw Interrupted();
    }
}

void FramePrint::write(const std::string& path, const Progress& progress)
{
    const PageFormat format = page_format(path);
    if (format == PageFormat::png && !inks().empty())
        throw OutputError(display_name(path, "standard output") +
                          ": PNG holds no CMYK; name a .tiff or .pdf");
    if (format == PageFormat::pdf)
        write_pdf_file(path);
    else
        write_pictures(path, progress);
}

std::vector<Image> FramePrint::pictures()
{
    std::vector<Image> pictures;
    for (const Page& page : pages_)
        pictures.push_back(drawn(page, [&] { return rasterized(page, form_, row_source()); }));
    return pictures;
}

} // namespace integral
