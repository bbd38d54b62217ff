// SPDX-License-Identifier: AGPL-3.0-or-later
// See integral_arguments.h.
#include "integral_arguments.h"

#include <list>
#include <string>
#include <strings.h>

namespace vfePlatform
{
static bool Begins_With(const std::string& argument, const std::string& option)
{
    return strncasecmp(argument.c_str(), option.c_str(), option.size()) == 0;
}

void QuoteIntegralArguments(char **argv)
{
    static std::list<std::string> replaced;
    for (; *argv != NULL; ++argv)
    {
        const std::string argument = *argv;
        std::string option;
        for (const char *name : {"Integral_Camera=", "Integral_Sheet=", "Integral_Panel="})
            if (Begins_With(argument, name))
                option = name;
        if (option.empty())
            continue;
        const std::string value = argument.substr(option.size());
        if (value.empty() || value[0] == '"' || value[0] == '\'')
            continue;
        const char quote = value.find('"') == std::string::npos ? '"' : '\'';
        replaced.push_back(option + quote + value + quote);
        *argv = &replaced.back()[0];
    }
}
}
