// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/content_hash.h"

#include "integral/base/file_bytes.h"

#include <openssl/evp.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace integral {

struct ContentHash::State {
    State() : context(EVP_MD_CTX_new())
    {
        if (!context)
            throw std::bad_alloc();
        if (EVP_DigestInit_ex(context, EVP_sha256(), nullptr) != 1) {
            EVP_MD_CTX_free(context);
            throw std::runtime_error("libcrypto has no SHA-256");
        }
    }
    ~State() { EVP_MD_CTX_free(context); }
    void feed(const char* bytes, std::size_t count) { EVP_DigestUpdate(context, bytes, count); }
    std::string digits()
    {
        unsigned char hash[EVP_MAX_MD_SIZE];
        unsigned int size = 0;
        EVP_DigestFinal_ex(context, hash, &size);
        std::string text;
        for (unsigned int i = 0; i < size; ++i)
            for (const int half : {hash[i] >> 4, hash[i] & 15})
                text += "0123456789abcdef"[half];
        return text;
    }
    EVP_MD_CTX* context;
};

namespace {

class Descriptor {
public:
    explicit Descriptor(const std::string& path)
        : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC))
    {
        if (descriptor_ < 0)
            throw InputError(path + ": cannot be read: " + std::strerror(errno));
    }
    ~Descriptor() { close(descriptor_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return descriptor_; }

private:
    int descriptor_;
};

} // namespace

ContentHash::ContentHash() : state_(std::make_unique<State>()) {}
ContentHash::~ContentHash() = default;

void ContentHash::add(const std::string& piece)
{
    const std::string size = std::to_string(piece.size()) + ":";
    state_->feed(size.data(), size.size());
    state_->feed(piece.data(), piece.size());
}

std::string ContentHash::digits() { return state_->digits(); }

std::string hash_of_file(const std::string& path)
{
    ContentHash::State plain; // without add()'s sizes of pieces: equal to sha256sum's hash
    const Descriptor file(path);
    std::vector<char> block(1 << 20);
    for (;;) {
        const ssize_t count = read(file.get(), block.data(), block.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            throw InputError(path + ": cannot be read: " + std::strerror(errno));
        if (count == 0)
            return plain.digits();
        plain.feed(block.data(), std::size_t(count));
    }
}

} // namespace integral
