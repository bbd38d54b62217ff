// SPDX-License-Identifier: AGPL-3.0-or-later
// Starts threads; if the system allows no more, prints a message and ends the program.
#ifndef POVRAY_BASE_NEWTHREAD_H
#define POVRAY_BASE_NEWTHREAD_H

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <boost/thread.hpp>

namespace pov_base
{

/// Starts a boost::thread, which the caller owns. If the system has no memory for its stack, or
/// allows this user no more threads, prints a message and ends the program with status 1: the
/// threads that wait for this one would wait for ever.
template <class... Arguments> boost::thread *New_Thread(Arguments&&...arguments)
{
    try
    {
        return new boost::thread(std::forward<Arguments>(arguments)...);
    }
    catch (const boost::thread_resource_error&)
    {
        std::fprintf(stderr,
                     "\nNo further thread can be started: the memory or the number of processes "
                     "that are allowed is used up. Give +WT1 for a single thread, or raise the "
                     "limits (ulimit -v, ulimit -u).\n");
        std::_Exit(EXIT_FAILURE);
    }
}

}

#endif
