// SPDX-License-Identifier: AGPL-3.0-or-later
// centroid PICTURE.png WIDTH_MM: the centre of the bright area in a view of a sheet WIDTH_MM wide,
// in mm from the sheet's centre (x to the right, y up). Reads the picture by libpng alone.
#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char** argv)
{
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    const double width_mm = argc == 3 ? std::atof(argv[2]) : 0;
    if (!(width_mm > 0) || !png_image_begin_read_from_file(&image, argv[1])) {
        std::fprintf(stderr, "usage: centroid PICTURE.png WIDTH_MM\n");
        return 2;
    }
    image.format = PNG_FORMAT_LINEAR_Y; // 16 bits, linear light
    std::vector<png_uint_16> pixels(PNG_IMAGE_SIZE(image) / sizeof(png_uint_16));
    if (!png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr)) {
        std::fprintf(stderr, "centroid: %s: %s\n", argv[1], image.message);
        return 3;
    }
    double sum = 0, x = 0, y = 0;
    for (png_uint_32 row = 0; row < image.height; ++row)
        for (png_uint_32 column = 0; column < image.width; ++column) {
            const double light = pixels[row * image.width + column];
            sum += light;
            x += light * (column + 0.5);
            y += light * (row + 0.5);
        }
    if (!(sum > 0)) {
        std::fprintf(stderr, "centroid: %s: nothing in it is bright\n", argv[1]);
        return 1;
    }
    const double pixel = width_mm / image.width;
    std::printf("%.6f %.6f\n", (x / sum - 0.5 * image.width) * pixel,
                (0.5 * image.height - y / sum) * pixel);
}
