// SPDX-License-Identifier: AGPL-3.0-or-later
// Lets POV-Ray's parser read a text in memory like an include file.
#ifndef POVRAY_BACKEND_INTEGRALOPTION_H
#define POVRAY_BACKEND_INTEGRALOPTION_H

#include <cstdio>
#include <string>

#include "base/fileinputoutput.h"

namespace pov
{

class OptionTextStream : public pov_base::IStream
{
public:
    /// `content` must not be empty.
    explicit OptionTextStream(const std::string& content)
        : IStream(pov_base::POV_File_Text_INC), text(content)
    {
        f = fmemopen(&text[0], text.size(), "r");
        fail = f == NULL;
    }

private:
    std::string text;
};

}

#endif
