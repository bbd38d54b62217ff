// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes streams to new files and reports whether everything was written.
#ifndef POVRAY_BASE_INTEGRALSTREAM_H
#define POVRAY_BASE_INTEGRALSTREAM_H

#include <cstdio>
#include <unistd.h>

#include "base/fileinputoutput.h"

namespace pov_base
{

class IntegralStream : public OStream
{
public:
    explicit IntegralStream(unsigned int file_type) : OStream(file_type) {}

    /// Writes to a descriptor, and closes it. The stream has failed if the descriptor is -1.
    IntegralStream(unsigned int file_type, int descriptor) : OStream(file_type)
    {
        f = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
        fail = f == NULL;
    }

    /// Opens a file by its name, without a check of IO restrictions.
    IntegralStream(unsigned int file_type, const std::string& name) : OStream(file_type)
    {
        f = std::fopen(name.c_str(), "wb");
        fail = f == NULL;
    }

    /// Flushes the file; returns whether everything was written. `on_disk`: also syncs it to disk.
    bool Finish(bool on_disk)
    {
        return !fail && std::fflush(f) == 0 && !std::ferror(f) &&
               (!on_disk || fsync(fileno(f)) == 0);
    }
};

}

#endif
