/* SPDX-License-Identifier: AGPL-3.0-or-later */
/* To be preloaded: of a program's threads the one whose number is $LATE starts four seconds late, as on a busy machine;
   the one whose number is $REFUSED and all later ones are refused, as by ulimit -u. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

struct start { void* (*run)(void*); void* with; };

static void* late(void* start)
{
    struct start own = *(struct start*)start;
    free(start);
    sleep(4);
    return own.run(own.with);
}

static int number(const char* name) { return getenv(name) ? atoi(getenv(name)) : 0; }

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* with)
{
    static int threads = 0; /* the first few are created one after another */
    int (*create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) = dlsym(RTLD_NEXT, "pthread_create");
    ++threads;
    if (number("REFUSED") > 0 && threads >= number("REFUSED"))
        return EAGAIN;
    if (threads != number("LATE"))
        return create(thread, attributes, run, with);
    struct start* start = malloc(sizeof *start);
    *start = (struct start){run, with};
    return create(thread, attributes, late, start);
}
