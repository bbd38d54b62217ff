/* SPDX-License-Identifier: AGPL-3.0-or-later */
/* To be preloaded: after $DISK_BYTES bytes written to files, whichever they are, $DISK says what happens: "full", nothing more can be
   written; "kill", the program is killed; "rename", it is killed once it has renamed a file, however much it has written. $DISK_COUNT: a
   file that gets the number of bytes written, at the program's end; $DISK_FOLDER: only files in that folder (its whole path) count; $PEAK: one that gets the most memory it had, KiB. It is always the same second, so that pictures do not differ by it. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static long long written; /* by one thread at a time: POV-Ray's front end has all files */

static int is(const char* what) { return getenv("DISK") && strcmp(getenv("DISK"), what) == 0; }

/* Whether an open file is on the bad disk. */
static int is_on_disk(int file)
{
    const char* folder = getenv("DISK_FOLDER");
    char link[64], path[4096];
    if (!folder)
        return 1;
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    ssize_t length = readlink(link, path, sizeof path - 1);
    path[length < 0 ? 0 : length] = 0;
    return strncmp(path, folder, strlen(folder)) == 0;
}

/* How many of `size` bytes fit. */
static size_t fitting(size_t size)
{
    long long left = (is("full") || is("kill") ? atoll(getenv("DISK_BYTES")) : 1LL << 60) - written;
    size_t fit = left < 0 ? 0 : (long long)size > left ? (size_t)left : size;
    written += fit;
    return fit;
}

static void end_it(void)
{
    if (is("kill"))
        kill(getpid(), SIGKILL);
    errno = ENOSPC;
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* file)
{
    size_t (*write_it)(const void*, size_t, size_t, FILE*) = dlsym(RTLD_NEXT, "fwrite");
    if (file == stdout || file == stderr || !is_on_disk(fileno(file)))
        return write_it(data, size, count, file);
    size_t fit = fitting(size * count);
    size_t done = write_it(data, 1, fit, file);
    if (fit == size * count)
        return done == fit ? count : 0;
    fflush(file);
    end_it();
    return fit / size;
}

int fputc(int byte, FILE* file)
{
    const unsigned char data = (unsigned char)byte;
    return fwrite(&data, 1, 1, file) == 1 ? data : EOF;
}

ssize_t write(int file, const void* data, size_t size)
{
    ssize_t (*write_it)(int, const void*, size_t) = dlsym(RTLD_NEXT, "write");
    struct stat status;
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || file <= 2 || !is_on_disk(file))
        return write_it(file, data, size);
    size_t fit = fitting(size);
    ssize_t done = fit > 0 ? write_it(file, data, fit) : 0;
    if (fit > 0 || size == 0)
        return done;
    end_it();
    return -1;
}

ssize_t pwrite64(int file, const void* data, size_t size, off64_t at)
{
    ssize_t (*write_it)(int, const void*, size_t, off64_t) = dlsym(RTLD_NEXT, "pwrite64");
    if (!is_on_disk(file))
        return write_it(file, data, size, at);
    size_t fit = fitting(size);
    ssize_t done = fit > 0 ? write_it(file, data, fit, at) : 0;
    if (fit > 0 || size == 0)
        return done;
    end_it();
    return -1;
}

ssize_t pwrite(int file, const void* data, size_t size, off_t at)
{
    return pwrite64(file, data, size, at);
}

int rename(const char* from, const char* to)
{
    int (*rename_it)(const char*, const char*) = dlsym(RTLD_NEXT, "rename");
    int status = rename_it(from, to);
    if (is("rename"))
        kill(getpid(), SIGKILL);
    return status;
}

time_t time(time_t* now)
{
    if (now)
        *now = 1000000000;
    return 1000000000;
}

static void tell(const char* name, long long number)
{
    FILE* file = getenv(name) ? fopen(getenv(name), "w") : NULL;
    if (file && fprintf(file, "%lld\n", number) > 0)
        fclose(file);
}

__attribute__((destructor)) static void tell_all(void)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    tell("DISK_COUNT", written);
    tell("PEAK", used.ru_maxrss);
}
