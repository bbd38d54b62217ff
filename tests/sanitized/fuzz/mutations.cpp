// SPDX-License-Identifier: AGPL-3.0-or-later
// A replacement for libFuzzer on machines without it: runs a target on files and on mutations of
// them, which are the same in every run.
//   FUZZ_TARGET=NAME mutations COUNT FILE...   each file as it is, then COUNT mutations of each
// Writes an input that fails to the file that FUZZ_FOUND names. Without FUZZ_TARGET: see main.cpp.
#include "tests/sanitized/fuzz/target.h"

#include "integral/base/file_bytes.h"

#include <sanitizer/common_interface_defs.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <unistd.h>

extern "C" int LLVMFuzzerInitialize(int* count, char*** words);
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size,
                                               std::size_t most, unsigned seed);

namespace {

using fuzz::Bytes;

constexpr std::size_t most_bytes = 4096;
constexpr unsigned most_seconds = 25; // that a target may take for one input

std::minstd_rand chance;
const std::vector<Bytes>* dictionary = nullptr;
Bytes current;

std::size_t below(std::size_t count) { return count ? chance() % count : 0; }

void keep_current()
{
    if (const char* path = std::getenv("FUZZ_FOUND"))
        if (std::FILE* file = std::fopen(path, "wb")) {
            std::fwrite(current.data(), 1, current.size(), file);
            std::fclose(file);
        }
}

void run(const Bytes& bytes)
{
    current = bytes;
    alarm(most_seconds);
    LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// Makes one small change.
void change(Bytes& bytes, std::size_t most)
{
    const std::size_t at = below(bytes.size());
    switch (below(8)) {
    case 0:
        if (!bytes.empty())
            bytes[at] = char(bytes[at] ^ (1 << below(8)));
        break;
    case 1:
    case 2:
        if (!bytes.empty())
            bytes[at] = char(below(256));
        break;
    case 3: bytes.insert(at, 1 + below(8), char(below(256))); break;
    case 4: bytes.erase(at, 1 + below(16)); break;
    case 5: bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(32))); break;
    case 6: bytes.resize(at); break;
    default:
        if (dictionary->empty())
            break;
        const Bytes& word = (*dictionary)[below(dictionary->size())];
        if (below(2))
            bytes.insert(at, word);
        else
            bytes.replace(at, word.size(), word);
    }
    bytes.resize(std::min(bytes.size(), most));
}

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t most)
{
    Bytes bytes(reinterpret_cast<const char*>(data), size);
    change(bytes, most);
    std::memcpy(data, bytes.data(), bytes.size());
    return bytes.size();
}

int main(int count, char** words)
{
    LLVMFuzzerInitialize(&count, &words);
    dictionary = &fuzz::chosen_target().words;
    __sanitizer_set_death_callback(keep_current);
    std::vector<Bytes> files;
    for (int k = 2; k < count; ++k)
        files.push_back(integral::read_file(words[k]));
    for (const Bytes& file : files)
        run(file);
    const int mutations = count > 1 ? std::atoi(words[1]) : 0;
    for (const Bytes& file : files)
        for (int k = 0; k < mutations; ++k) {
            Bytes bytes = file.substr(0, most_bytes);
            for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
                const std::size_t size = bytes.size();
                bytes.resize(most_bytes);
                unsigned char* data = reinterpret_cast<unsigned char*>(&bytes[0]);
                bytes.resize(LLVMFuzzerCustomMutator(data, size, most_bytes, unsigned(chance())));
            }
            run(bytes);
        }
    std::printf("%zu files, %zu runs\n", files.size(), files.size() * std::size_t(1 + mutations));
}
