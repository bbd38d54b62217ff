// SPDX-License-Identifier: AGPL-3.0-or-later
// The fuzzing program: the targets of targets.cpp, run by libFuzzer or by mutations.cpp.
//   readers --targets                 prints the targets' names
//   readers --seeds NAME FOLDER       writes a target's seeds into FOLDER, and its dictionary into
//                                     FOLDER.words
//   FUZZ_TARGET=NAME readers ...      fuzzes, with the options of libFuzzer or of mutations.cpp
#include "tests/sanitized/fuzz/target.h"

#include "integral/base/file_bytes.h"
#include "integral/cli/command.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sys/mman.h>
#include <unistd.h>

namespace fuzz {
namespace {

const Target* chosen = nullptr;

const Target& target_named(const char* name)
{
    for (const Target& target : targets)
        if (name && std::strcmp(target.name, name) == 0)
            return target;
    if (name && std::strcmp(planted_fault.name, name) == 0)
        return planted_fault;
    std::fprintf(stderr, "there is no target %s; readers --targets lists them\n",
                 name ? name : "(FUZZ_TARGET is not set)");
    std::exit(2);
}

/// A fault of the program, in contrast to an error in its input.
[[noreturn]] void found(const char* what, const char* message)
{
    std::fprintf(stderr, "%s: %s: %s\n", chosen->name, what, message);
    std::abort();
}

void expect_one_line(const char* message)
{
    if (!*message || std::any_of(message, message + std::strlen(message),
                                 [](unsigned char c) { return std::iscntrl(c); }))
        found("a message that is not one line", message);
}

void write_seeds(const Target& target, const std::string& folder)
{
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const Bytes& seed : target.seeds())
        integral::write_file(folder + "/" + std::to_string(++number), seed);
    Bytes words;
    for (const Bytes& word : target.words) {
        words += '"';
        for (const unsigned char c : word) {
            char text[8];
            std::snprintf(text, sizeof text, std::isalnum(c) ? "%c" : "\\x%02x", c);
            words += text;
        }
        words += "\"\n";
    }
    integral::write_file(folder + ".words", words);
}

struct ScratchFolder {
    std::string path = std::filesystem::temp_directory_path() / "integral-fuzz-XXXXXX";
    ScratchFolder()
    {
        if (!mkdtemp(&path[0]))
            std::abort();
    }
    ~ScratchFolder() { std::filesystem::remove_all(path); }
};

} // namespace

std::string file_of(const Bytes& bytes, int slot)
{
    static const int files[] = {memfd_create("input", 0), memfd_create("input", 0)};
    const int file = files[slot];
    if (ftruncate(file, 0) != 0 ||
        pwrite(file, bytes.data(), bytes.size(), 0) != ssize_t(bytes.size()))
        std::abort();
    return "/proc/self/fd/" + std::to_string(file);
}

const Target& chosen_target() { return *chosen; }

std::string scratch_path(const std::string& name)
{
    static const ScratchFolder folder;
    return folder.path + "/" + name;
}

} // namespace fuzz

using namespace fuzz;

extern "C" int LLVMFuzzerInitialize(int* count, char*** words)
{
    const auto word = [&](int i) { return i < *count ? (*words)[i] : ""; };
    if (std::strcmp(word(1), "--targets") == 0) {
        for (const Target& target : targets)
            std::printf("%s\n", target.name);
        std::exit(0);
    }
    if (std::strcmp(word(1), "--seeds") == 0) {
        write_seeds(target_named(word(2)), word(3));
        std::exit(0);
    }
    chosen = &target_named(std::getenv("FUZZ_TARGET"));
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    try {
        chosen->run(Bytes(reinterpret_cast<const char*>(data), size));
    } catch (const integral::InputError& error) {
        expect_one_line(error.what());
    } catch (const integral::UsageError& error) {
        expect_one_line(error.what());
    } catch (const std::exception& error) {
        found("an error that is not the input's", error.what());
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size,
                                               std::size_t most, unsigned seed)
{
    if (!chosen->mutated || seed % 8 == 0)
        return LLVMFuzzerMutate(data, size, most);
    const Bytes bytes = chosen->mutated(Bytes(reinterpret_cast<const char*>(data), size), most,
                                        seed / 8);
    std::memcpy(data, bytes.data(), std::min(bytes.size(), most));
    return std::min(bytes.size(), most);
}
