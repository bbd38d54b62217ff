// SPDX-License-Identifier: AGPL-3.0-or-later
// The table of fuzz targets (targets.cpp) and the types of its entries.
#ifndef INTEGRAL_TESTS_FUZZ_TARGET_H
#define INTEGRAL_TESTS_FUZZ_TARGET_H

#include <string>
#include <vector>

namespace fuzz {

using Bytes = std::string;

/// A reader, and the files from which its fuzzing starts. To add a target, write a line in the
/// table of targets.cpp and the function that it names.
struct Target {
    const char* name;
    void (*run)(const Bytes&);     ///< reads the bytes; may throw InputError and UsageError, whose
                                   ///< messages are one line
    std::vector<Bytes> (*seeds)(); ///< small files that are read, of every kind
    std::vector<Bytes> words;      ///< byte sequences of the format, which mutations insert
    Bytes (*mutated)(Bytes, std::size_t most,
                     unsigned seed) = nullptr; ///< the format's own mutation; else libFuzzer's
};

extern const std::vector<Target> targets;
extern const Target planted_fault; ///< a target that is at fault, for the test of the fuzzing
                                   ///< itself

/// The target that the environment's FUZZ_TARGET names, once LLVMFuzzerInitialize has run.
const Target& chosen_target();

/// The path of a file in memory with these bytes, until the next call for the same `slot` (0 or 1).
std::string file_of(const Bytes& bytes, int slot = 0);

/// A path in a folder of this process, which is removed at its end.
std::string scratch_path(const std::string& name);

// Seeds (seeds.cpp).
std::vector<Bytes> png_seeds(), exr_seeds(), tiff_seeds(), jpeg_seeds(), phone_seeds(),
    depth_seeds(), sheet_seeds(), profile_seeds(), command_seeds();
std::vector<Bytes> panel_seeds(), tolerance_seeds(), manifest_seeds(), float_map_seeds(),
    mesh_seeds(), layer_stack_seeds(), response_seeds();

/// Changes a PNG chunk by chunk and gives each its length and checksum again (png_mutation.cpp).
Bytes mutated_png(Bytes png, std::size_t most, unsigned seed);

struct Chunk {
    Bytes type, data; ///< type: four letters
};
Bytes png_of(const std::vector<Chunk>& chunks);

/// Runs a command of the integral program on a geometry that the bytes choose (commands.cpp).
void run_command(const Bytes& bytes);

} // namespace fuzz

/// libFuzzer's own mutation, in place; returns the new size.
extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t most);

#endif
