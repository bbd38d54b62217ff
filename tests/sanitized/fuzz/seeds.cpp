// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes small files of every kind that the commands read, as this project writes them and as other
// programs do.
#include "tests/sanitized/fuzz/target.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json_fields.h"
#include "integral/io/codecs.h"
#include "integral/io/markup.h"
#include "integral/io/mpo_file.h"
#include "integral/print/colour_profile.h"
#include "integral/sheet/panel.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <half.h>
#include <lcms2.h>
#include <tiffio.h>
#include <zlib.h>

#include <random>

namespace fuzz {
namespace {

using namespace integral;

constexpr int width = 5, height = 4;

std::string document(bool complete)
{
    FrameMetadata m;
    m.sheet.arrangement = Arrangement::hexagonal;
    m.film = {width, height, {0.1, 0.2}, Subpixels::rgb};
    m.aperture = {300, 200, 100, ApertureShape::ellipse};
    if (complete) {
        m.placement = Placement{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5};
        m.encoding = {Encoding::Kind::power, 1.8};
        m.render = RenderRecord{};
        m.render->error = ErrorEstimate{};
        m.quilt = QuiltRecord{{2, 3}, 1, EyeGrid{{100, 50}, 300}};
    }
    return to_json(m);
}

template <class Sample> Image picture(int channels)
{
    std::mt19937 random(7);
    Image image = make_image<Sample>(
        width, height, channels,
        std::is_integral<Sample>::value ? Encoding{} : Encoding{Encoding::Kind::linear, 1});
    for (Sample& s : std::get<std::vector<Sample>>(image.samples))
        s = Sample(random() % 256) / (std::is_integral<Sample>::value ? 1 : 255);
    return image;
}

std::vector<DecodedImage> pictures()
{
    std::vector<DecodedImage> all;
    for (const int channels : {3, 4})
        for (const Image& image : {picture<std::uint8_t>(channels),
                                   picture<std::uint16_t>(channels), picture<float>(channels)})
            all.push_back({image, document(false), Vec2{0.1, 0.2}, ""});
    return all;
}

/// Adds a truncated copy of each file.
std::vector<Bytes> and_halves(std::vector<Bytes> seeds)
{
    const std::size_t count = seeds.size();
    for (std::size_t k = 0; k < count; ++k)
        seeds.push_back(seeds[k].substr(0, seeds[k].size() * (k % 3 + 1) / 4));
    return seeds;
}

/// JSON documents with the deepest nesting, and with the most fields, that inputs of the fuzzer's
/// length can have.
std::vector<Bytes> endless_documents()
{
    constexpr int bytes = 4000;
    Bytes deep, many = "{";
    while (deep.size() < bytes)
        deep += "{\"files\":[";
    for (int k = 0; many.size() < bytes; ++k)
        many += "\"" + std::to_string(k) + "\":{},";
    return {deep, "{\"sheet\":" + Bytes(bytes / 2, '[') + Bytes(bytes / 2, ']') + "}",
            many + "\"\":\"{\"}", "{\"" + Bytes(bytes, 'n') + "\":0}",
            "[\"" + Bytes(bytes / 2, '[') + "{}" + Bytes(bytes / 2 - 10, ']') + "\"]"};
}

std::vector<Bytes> and_endless(std::vector<Bytes> seeds)
{
    for (const Bytes& document : endless_documents())
        seeds.push_back(document);
    return seeds;
}

/// A PNG of zeros, of any colour type and depth.
Bytes plain_png(int bits, int type, bool interlaced)
{
    static const int samples[] = {1, 0, 3, 1, 2, 0, 4};
    const std::size_t row = 1 + std::size_t(width * samples[type] * bits + 7) / 8;
    const Bytes raw(row * height * 2, '\0'); // interlacing needs a little more
    Bytes packed(compressBound(uLong(raw.size())), '\0');
    uLongf size = uLongf(packed.size());
    compress(reinterpret_cast<Bytef*>(&packed[0]), &size,
             reinterpret_cast<const Bytef*>(raw.data()), uLong(raw.size()));
    packed.resize(size);
    std::vector<Chunk> chunks = {{"IHDR", Bytes{0, 0, 0, char(width), 0, 0, 0, char(height),
                                                char(bits), char(type), 0, 0, char(interlaced)}},
                                 {"gAMA", Bytes("\0\0\xb1\x8f", 4)}};
    if (type == 3)
        chunks.insert(chunks.end(),
                      {{"PLTE", Bytes("\xff\0\0\0\xff\0", 6)}, {"tRNS", Bytes("\x80\xff", 2)}});
    chunks.insert(chunks.end(), {{"IDAT", packed}, {"IEND", ""}});
    return png_of(chunks);
}

/// A file that OpenEXR has written.
Bytes exr_of(const std::vector<std::string>& names, Imf::PixelType type,
             Imf::Compression compression, bool tiles)
{
    const std::string path = scratch_path("seed.exr"), text = document(false);
    Imf::Header header(width, height);
    header.compression() = compression;
    header.insert("integral", Imf::StringAttribute(text));
    std::vector<float> floats(std::size_t(width * height), 0.5f);
    std::vector<half> halves(floats.begin(), floats.end());
    Imf::FrameBuffer source;
    for (const std::string& name : names) {
        const bool is_half = type == Imf::HALF;
        header.channels().insert(name, Imf::Channel(type));
        source.insert(name, Imf::Slice(type,
                                       is_half ? reinterpret_cast<char*>(halves.data())
                                               : reinterpret_cast<char*>(floats.data()),
                                       is_half ? 2 : 4, std::size_t(is_half ? 2 : 4) * width));
    }
    if (tiles) {
        header.setTileDescription(Imf::TileDescription(2, 2, Imf::ONE_LEVEL));
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(source);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(source);
        file.writePixels(height);
    }
    return read_file(path);
}

struct TiffForm {
    int bits, samples, photometric, compression;
    bool planes = false, tiles = false, floats = false, big = false;
};

/// A file that libtiff has written.
Bytes tiff_of(const TiffForm& form)
{
    const std::string path = scratch_path("seed.tiff");
    TIFF* tiff = TIFFOpen(path.c_str(), form.big ? "w8" : "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, form.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.samples);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, form.photometric);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, form.compression);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG,
                 form.planes ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    if (form.floats)
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    std::vector<std::uint16_t> colours(1 << 8);
    if (form.photometric == PHOTOMETRIC_PALETTE)
        TIFFSetField(tiff, TIFFTAG_COLORMAP, colours.data(), colours.data(), colours.data());
    Bytes row(16 * 16 * 16, '\x40');
    if (form.tiles) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
        TIFFWriteEncodedTile(tiff, 0, &row[0], TIFFTileSize(tiff));
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 3);
        for (int plane = 0; plane < (form.planes ? form.samples : 1); ++plane)
            for (int y = 0; y < height; ++y)
                TIFFWriteScanline(tiff, &row[0], std::uint32_t(y), std::uint16_t(plane));
    }
    TIFFClose(tiff);
    return read_file(path);
}

} // namespace

std::vector<Bytes> png_seeds()
{
    std::vector<Bytes> seeds;
    for (const DecodedImage& picture : pictures())
        if (sample_bits(picture.image) < 32)
            seeds.push_back(encode_png(picture));
    for (const Bytes& document : endless_documents())
        seeds.push_back(encode_png({picture<std::uint8_t>(3), document, {}, ""}));
    for (const bool interlaced : {false, true})
        for (const auto& [bits, type] :
             {std::pair(1, 0), {2, 0}, {16, 0}, {4, 3}, {8, 3}, {8, 4}, {16, 4}, {16, 6}})
            seeds.push_back(plain_png(bits, type, interlaced));
    return and_halves(seeds);
}

std::vector<Bytes> exr_seeds()
{
    std::vector<Bytes> seeds;
    for (const DecodedImage& picture : pictures())
        if (sample_bits(picture.image) == 32)
            seeds.push_back(encode_exr(picture));
    for (const auto compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::PIZ_COMPRESSION,
          Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION})
        seeds.push_back(exr_of({"R", "G", "B", "A"}, Imf::HALF, compression,
                               compression == Imf::PIZ_COMPRESSION));
    seeds.push_back(exr_of({"Y"}, Imf::FLOAT, Imf::ZIP_COMPRESSION, false));
    seeds.push_back(exr_of({"Y", "A"}, Imf::HALF, Imf::ZIP_COMPRESSION, true));
    seeds.push_back(exr_of({"a.R", "a.G", "a.B", "beauty.R", "beauty.G", "beauty.B"}, Imf::HALF,
                           Imf::NO_COMPRESSION, false));
    return and_halves(seeds);
}

std::vector<Bytes> depth_seeds()
{
    return and_halves({exr_of({"Z", "A"}, Imf::FLOAT, Imf::ZIP_COMPRESSION, false),
                       exr_of({"Z", "A"}, Imf::HALF, Imf::NO_COMPRESSION, false),
                       exr_of({"Z", "A", "R"}, Imf::FLOAT, Imf::PIZ_COMPRESSION, true)});
}

std::vector<Bytes> tiff_seeds()
{
    std::vector<Bytes> seeds;
    for (const DecodedImage& picture : pictures())
        seeds.push_back(encode_tiff(picture));
    const TiffForm forms[] = {
        {8, 1, PHOTOMETRIC_MINISWHITE, COMPRESSION_NONE},
        {16, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_LZW},
        {8, 3, PHOTOMETRIC_RGB, COMPRESSION_PACKBITS},
        {8, 4, PHOTOMETRIC_RGB, COMPRESSION_LZW, true},
        {32, 3, PHOTOMETRIC_RGB, COMPRESSION_ADOBE_DEFLATE, true, false, true},
        {8, 1, PHOTOMETRIC_PALETTE, COMPRESSION_NONE},
        {1, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_CCITTFAX4},
        {8, 3, PHOTOMETRIC_RGB, COMPRESSION_LZW, false, true},
        {16, 3, PHOTOMETRIC_RGB, COMPRESSION_NONE, false, false, false, true},
        {8, 4, PHOTOMETRIC_SEPARATED, COMPRESSION_LZW},
        {12, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_NONE},
        {16, 3, PHOTOMETRIC_RGB, COMPRESSION_LZW, true, true},
        {4, 1, PHOTOMETRIC_PALETTE, COMPRESSION_PACKBITS, false, true},
        {16, 3, PHOTOMETRIC_RGB, COMPRESSION_NONE, false, false, true},
        {8, 3, PHOTOMETRIC_YCBCR, COMPRESSION_JPEG, false, true}};
    for (const TiffForm& form : forms)
        seeds.push_back(tiff_of(form));
    return and_halves(seeds);
}

/// JPEGs, and pairs of them as in an MPO.
std::vector<Bytes> jpeg_seeds()
{
    std::vector<Bytes> seeds;
    for (const DecodedImage& picture : pictures()) {
        const Image& image = picture.image;
        seeds.push_back(encode_jpeg(image, 90));
        seeds.push_back(mpo_of_views({image, image}, 50, 63));
    }
    for (const Bytes& profile : profile_seeds())
        if (profile.size() < 60000) {
            const std::size_t size = profile.size() + 16; // of the segment
            seeds.push_back("\xff\xd8\xff\xe2" + Bytes{char(size >> 8), char(size)} +
                            Bytes("ICC_PROFILE\0\1\1", 14) + profile + seeds[0].substr(2));
        }
    return and_halves(seeds);
}

/// JPEGs with depth inside, as phones store it: as text in the metadata, and behind the photograph.
std::vector<Bytes> phone_seeds()
{
    std::vector<Bytes> seeds;
    const auto segment = [](const Bytes& content) {
        const std::size_t size = content.size() + 2;
        return "\xff\xe1" + Bytes{char(size >> 8), char(size)} + content;
    };
    const Bytes name("http://ns.adobe.com/xap/1.0/\0", 29);
    for (const DecodedImage& picture : pictures()) {
        const Bytes jpeg = encode_jpeg(picture.image, 50);
        for (const char* format : {"RangeInverse", "RangeLinear"})
            seeds.push_back(jpeg.substr(0, 2) +
                            segment(name + "<a GDepth:Format=\"" + format +
                                    "\" GDepth:Near=\"1\" GDepth:Far=\"3\" GDepth:Data=\"" +
                                    base64(jpeg) + "\"/>") +
                            jpeg.substr(2));
        seeds.push_back(jpeg.substr(0, 2) +
                        segment(name +
                                "<a Item:Mime=\"\"/><a Item:Mime=\"\" Item:Semantic=\"Depth\" "
                                "Item:Length=\"" +
                                std::to_string(jpeg.size()) + "\"/>") +
                        jpeg.substr(2) + jpeg);
    }
    return and_halves(seeds);
}

std::vector<Bytes> sheet_seeds()
{
    return and_endless(and_halves(
        {document(false), document(true),
         R"({"sheet":{"arrangement":"lenticular","pitch_mm":1,"thickness_mm":3,"ior":1.6},)"
         R"("film":{"pixel_pitch_mm":[0.1,0.1]},)"
         R"("aperture":{"distance_mm":300,"width_mm":null}})"}));
}

std::vector<Bytes> panel_seeds()
{
    std::vector<Bytes> seeds;
    for (const Panel& panel : known_panels()) {
        seeds.push_back(to_json(panel));
        if (panel.calibration)
            seeds.push_back(text_of(json_of(*panel.calibration)));
    }
    return and_endless(and_halves(seeds));
}

std::vector<Bytes> tolerance_seeds()
{
    return and_endless(and_halves(
        {R"({"defaults":{"max_rmse":0.002,"min_ssim":0.99},"files":{"glass/*":{"max_rmse":0.01},)"
         R"("a?[0-9].png":{"min_ssim":null,)"
         R"("max_difference":1}}})"}));
}

std::vector<Bytes> manifest_seeds()
{
    return and_endless(and_halves(
        {R"({"output":"out","scenes":[{"name":"a","file":"/dev/null","size":[60,40],)"
         R"("options":["+A0.1"],"declare":{"N":2}}],)"
         R"("sheets":[{"name":"s","camera":"lens_sheet{square pitch 1 thickness 3 ior 1.6} film{dpi 300}"}],)"
         R"("papers":[{"name":"p","paper":"A5","options":["--mirror"]}],"panels":[{"name":"l","panel":"thesis-lcd"}],)"
         R"("previews":[{"name":"v","options":["--eye","0,0,400"]}]})",
         R"({"output":"out","scenes":[{"name":"a","file":"/dev/null"}],"jobs":[{"scene":"a"}]})"}));
}

std::vector<Bytes> float_map_seeds()
{
    const Bytes two("\0\0\x80\x3f\0\0\x80\xbf", 8); // 1 and -1
    return and_halves({"Pf\n2 1\n-1.0\n" + two, "Pf\n1 2\n1\n" + two,
                       "PF\n1 1\n-1\n" + two + Bytes("\0\0\xc0\x7f", 4)});
}

std::vector<Bytes> mesh_seeds()
{
    return and_halves({"# a cube's side\nv 0 0 0\nv 1 0 0 1 0.5 0\nv 1 1 0\nv 0 1 -1e3\n"
                       "vt 0 0\nvn 0 0 1\no it\ng part\ns off\nusemtl red\n"
                       "f 1/1/1 2//1 3/1 -1\nl 1 2 3\np 1 -2\n",
                       "mtllib none.mtl\nv 1 2 3\np 1\n"});
}

std::vector<Bytes> layer_stack_seeds()
{
    Bytes deep = "<image w='3' h='2'>";
    for (int k = 0; k < 500; ++k)
        deep += "<stack>";
    return and_halves(
        {R"(<?xml version="1.0" encoding="UTF-8"?><image version="0.0.5" w="60" h="40"><stack>)"
         R"(<layer name="logo@-2" src="data/0.png" x="-4" y="34" opacity="0.25" visibility="hidden"/>)"
         R"(<stack name="g&amp;h" composite-op="svg:multiply"><layer src="data/1.png"/></stack></stack></image>)",
         deep,
         "<!DOCTYPE image [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;&a;'>]><image>&b;</image>"});
}

std::vector<Bytes> response_seeds()
{
    return and_halves({"# grey, mm\n0, 0\n0.5, 0.02\n1, 0.1\n", "0 0.01\n1 0.3\n"});
}

std::vector<Bytes> profile_seeds()
{
    std::vector<Bytes> seeds = {srgb_profile()};
    // A profile with a table for each rendering intent, as printers' profiles have.
    const cmsHPROFILE srgb = cmsCreate_sRGBProfile(), lab = cmsCreateLab4Profile(nullptr);
    const cmsHTRANSFORM transform = cmsCreateTransform(lab, TYPE_Lab_DBL, srgb, TYPE_RGB_16,
                                                       INTENT_PERCEPTUAL, cmsFLAGS_LOWRESPRECALC);
    const cmsHPROFILE table = cmsTransform2DeviceLink(
        transform, 4.3, cmsFLAGS_GUESSDEVICECLASS | cmsFLAGS_LOWRESPRECALC);
    cmsUInt32Number size = 0;
    if (table && cmsSaveProfileToMem(table, nullptr, &size)) {
        seeds.emplace_back(size, '\0');
        cmsSaveProfileToMem(table, &seeds.back()[0], &size);
    }
    cmsCloseProfile(table);
    cmsDeleteTransform(transform);
    cmsCloseProfile(lab);
    cmsCloseProfile(srgb);
    return and_halves(seeds);
}

std::vector<Bytes> command_seeds()
{
    std::mt19937 random(1);
    std::vector<Bytes> seeds;
    for (int k = 0; k < 64; ++k) {
        Bytes bytes(64, '\0');
        for (char& byte : bytes)
            byte = char(random());
        bytes[0] = char(k);
        seeds.push_back(bytes);
    }
    return seeds;
}

} // namespace fuzz
