// SPDX-License-Identifier: AGPL-3.0-or-later
// Command line and exit status of the measurement programs.
#ifndef INTEGRAL_BENCH_PROGRAM_H
#define INTEGRAL_BENCH_PROGRAM_H

#include "integral/base/file_bytes.h"

#include <boost/program_options.hpp>

#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>

namespace integral::bench {

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The folder of this program: BUILD/bench.
inline std::filesystem::path own_folder()
{
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// Parses a command line that consists of options only. Throws UsageError.
inline boost::program_options::variables_map parsed(
    int count, char** words, const boost::program_options::options_description& all)
{
    boost::program_options::variables_map arguments;
    try {
        boost::program_options::store(boost::program_options::command_line_parser(count, words)
                                          .options(all)
                                          .positional({})
                                          .run(),
                                      arguments);
        boost::program_options::notify(arguments);
    } catch (const boost::program_options::error& error) {
        throw UsageError(error.what());
    }
    return arguments;
}

/// Calls work() and returns its exit status, or 2 after a UsageError, 4 after an OutputError, 1
/// after any other exception.
inline int status_of(const char* name, const std::function<int()>& work)
{
    const auto say = [&](const std::exception& error, int status) {
        std::cerr << name << ": " << error.what() << std::endl;
        return status;
    };
    try {
        return work();
    } catch (const UsageError& error) {
        return say(error, 2);
    } catch (const OutputError& error) {
        return say(error, 4);
    } catch (const std::filesystem::filesystem_error& error) {
        return say(error, 4);
    } catch (const std::exception& error) {
        return say(error, 1);
    }
}

} // namespace integral::bench

#endif
