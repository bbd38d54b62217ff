// SPDX-License-Identifier: AGPL-3.0-or-later
// Prints a page of noise through integral/print/spool.h, for print_cups.test.
//
//   spool [--printer NAME] [--title TITLE] [--size WxH] [--dpi X,Y] [--levels N] [--border N]
//         [--pages N] [--copies N] [--medium NAME] [--option NAME=VALUE]
//         [--patience SECONDS] [--stop-at STEPS] [--keep FILE]
//
// Every sample is one of N levels (of 256: any value), `border` pixels round the page white.
// --keep: the pages' samples as they are (R, G, B; row by row), page after page. --stop-at:
// progress says stop at that many steps of 1000. Prints the job's number, or "interrupted", and how
// progress went; with --printers the server's printers instead.
#include "integral/base/file_bytes.h"
#include "integral/print/spool.h"

#include <cstdio>
#include <exception>
#include <random>

int main(int count, char** arguments)
{
    using namespace integral;
    SpoolJob job;
    int width = 1240, height = 1844, levels = 256, border = 0, pages = 1, stop_at = 1001;
    std::string keep, kept;
    try {
        for (int i = 1; i < count; ++i) {
            const std::string name = arguments[i];
            if (name == "--printers") {
                for (const std::string& printer : printers())
                    std::puts(printer.c_str());
                return 0;
            }
            const std::string value = i + 1 < count ? arguments[++i] : "";
            if (name == "--printer")
                job.printer = value;
            else if (name == "--title")
                job.title = value;
            else if (name == "--size")
                std::sscanf(value.c_str(), "%dx%d", &width, &height);
            else if (name == "--dpi")
                std::sscanf(value.c_str(), "%lf,%lf", &job.dpi.x, &job.dpi.y);
            else if (name == "--levels")
                levels = std::stoi(value);
            else if (name == "--border")
                border = std::stoi(value);
            else if (name == "--pages")
                pages = std::stoi(value);
            else if (name == "--copies")
                job.copies = std::stoi(value);
            else if (name == "--medium")
                job.medium = value;
            else if (name == "--option")
                job.options.emplace_back(value.substr(0, value.find('=')),
                                         value.substr(value.find('=') + 1));
            else if (name == "--patience")
                job.patience = std::stod(value);
            else if (name == "--stop-at")
                stop_at = std::stoi(value);
            else if (name == "--keep")
                keep = value;
            else
                throw std::runtime_error(name + ": no such option");
        }
        std::mt19937 random(20);
        for (int p = 0; p < pages; ++p) {
            Image page = make_image<std::uint8_t>(width, height, 3, Encoding());
            std::vector<std::uint8_t>& samples = std::get<std::vector<std::uint8_t>>(page.samples);
            for (int y = 0; y < height; ++y)
                for (int i = 0; i < width * 3; ++i) {
                    const bool inside = y >= border && y < height - border && i / 3 >= border &&
                                        i / 3 < width - border;
                    samples[std::size_t(y) * width * 3 + i] = inside ? std::uint8_t(
                                                                           (random() >> 8) %
                                                                           unsigned(levels) * 255 /
                                                                           unsigned(levels - 1))
                                                                     : 255;
                }
            kept.append(samples.begin(), samples.end());
            job.pages.push_back(std::move(page));
        }
        if (!keep.empty())
            write_file(keep, kept);
        int last = -1;
        bool forward = true;
        const std::optional<int> number = spool(job, [&](int done, int total) {
            forward = forward && done >= last && done <= total;
            last = done;
            return done < stop_at;
        });
        if (number)
            std::printf("job %d\n", *number);
        else
            std::puts("interrupted");
        std::printf("progress %s to %d\n", forward ? "forward" : "backward", last);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "spool: %s\n", error.what());
        return 4;
    }
}
