// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks which limits of control groups are found, in folders that stand for /proc and /sys.
#include "integral/base/memory.h"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace integral;

namespace {

namespace fs = std::filesystem;

/// A folder with files as in /proc and /sys.
struct System {
    System()
    {
        std::string name = (fs::temp_directory_path() / "integral-memory.XXXXXX").string();
        root = mkdtemp(name.data());
    }
    ~System() { fs::remove_all(root); }
    void write(const std::string& path, const std::string& text) const
    {
        fs::create_directories((root + path).substr(0, (root + path).rfind('/')));
        std::ofstream(root + path) << text << "\n";
    }
    double free() const { return free_of_control_groups(root); }
    std::string root;
};

} // namespace

BOOST_AUTO_TEST_SUITE(io_memory)

BOOST_AUTO_TEST_CASE(without_a_limit_any_memory_is_free)
{
    System system;
    BOOST_TEST(system.free() == 1e300);
    system.write("/proc/self/cgroup", "0::/a");
    system.write("/sys/fs/cgroup/a/memory.max", "max");
    system.write("/sys/fs/cgroup/a/memory.current", "5");
    BOOST_TEST(system.free() == 1e300);
}

BOOST_AUTO_TEST_CASE(version_2_with_its_file_cache_and_the_groups_above)
{
    System system;
    system.write("/proc/self/cgroup", "0::/a/b");
    system.write("/sys/fs/cgroup/a/b/memory.max", "1000");
    system.write("/sys/fs/cgroup/a/b/memory.current", "700");
    BOOST_TEST(system.free() == 300);
    system.write("/sys/fs/cgroup/a/b/memory.stat", "anon 1\ninactive_file 50\nactive_file 20");
    BOOST_TEST(system.free() == 350);
    system.write("/sys/fs/cgroup/a/memory.max", "900");
    system.write("/sys/fs/cgroup/a/memory.current", "800");
    BOOST_TEST(system.free() == 100);
}

BOOST_AUTO_TEST_CASE(version_1_with_its_file_cache_and_the_groups_above)
{
    System system;
    system.write("/proc/self/cgroup", "12:pids:/x\n4:cpu,memory:/a/b\n1:name=systemd:/y\n0::/z");
    const std::string folder = "/sys/fs/cgroup/memory/a/b/memory.";
    system.write(folder + "limit_in_bytes", "1000");
    system.write(folder + "usage_in_bytes", "700");
    BOOST_TEST(system.free() == 300);
    system.write(folder + "stat", "inactive_file 1\ntotal_inactive_file 50");
    BOOST_TEST(system.free() == 350);
    system.write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "900");
    system.write("/sys/fs/cgroup/memory/memory.usage_in_bytes", "800");
    BOOST_TEST(system.free() == 100);
}

BOOST_AUTO_TEST_CASE(a_container_whose_path_is_that_of_its_host)
{
    System system;
    system.write("/proc/self/cgroup", "4:memory:/docker/0123");
    system.write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "1000");
    system.write("/sys/fs/cgroup/memory/memory.usage_in_bytes", "400");
    BOOST_TEST(system.free() == 600);
}

BOOST_AUTO_TEST_SUITE_END()
