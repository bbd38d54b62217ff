// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the files of batches: hashes, the files that scenes read, records and locks.
#include "integral/base/file_bytes.h"
#include "integral/base/file_bytes.h"
#include "integral/batch/batch_folder.h"
#include "integral/batch/content_hash.h"
#include "integral/batch/lock_file.h"
#include "integral/batch/scene_files.h"
#include "integral/batch/source_json.h"
#include "integral/batch/step_record.h"
#include "integral/io/image_file.h"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace integral;

BOOST_AUTO_TEST_SUITE(batch_files)

namespace {

/// A folder of the test's own.
struct Folder {
    Folder()
    {
        char name[] = "/tmp/integral-unit.XXXXXX";
        BOOST_REQUIRE(mkdtemp(name));
        path = name;
        setenv("POVINI", (path + "/none.ini").c_str(), 1);
        setenv("POVINC", "", 1);
        setenv("HOME", path.c_str(), 1);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    void write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories(std::filesystem::path(path + "/" + name).parent_path());
        write_file(path + "/" + name, text);
    }
    std::string path;
};

std::string names_of(const std::vector<SceneFile>& files)
{
    std::string names;
    for (const SceneFile& file : files)
        names += file.name + " ";
    return names;
}

/// Moves a file's modification time into the past.
void made_ago(const std::string& path, std::chrono::seconds ago)
{
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - ago);
}

std::string refusal(const std::string& json)
{
    try {
        SourceJson::parse("m.json", json).allow({"a", "b"});
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(file_hash_is_sha256)
{
    const Folder folder;
    folder.write("abc", "abc"); // FIPS 180-2, appendix B.1
    BOOST_TEST(hash_of_file(folder.path + "/abc") ==
               "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    folder.write("empty", "");
    BOOST_TEST(hash_of_file(folder.path + "/empty") ==
               "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    folder.write("long", std::string(1000000, 'a')); // B.3
    BOOST_TEST(hash_of_file(folder.path + "/long") ==
               "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    BOOST_CHECK_THROW(hash_of_file(folder.path + "/none"), InputError);
    BOOST_CHECK_THROW(hash_of_file(folder.path), InputError);
}

BOOST_AUTO_TEST_CASE(pieces_are_told_apart)
{
    ContentHash one, other;
    one.add("ab"), one.add("c");
    other.add("a"), other.add("bc");
    BOOST_TEST(one.digits() != other.digits());
}

BOOST_AUTO_TEST_CASE(scene_names_its_files)
{
    const Folder folder;
    folder.write("s/scene.pov", "#include \"a.inc\"\n#include \"bare\"\npigment { image_map { png "
                                "\"sky.png\" } }\n#debug \"not a file\"\n// \"x.inc\"\n");
    folder.write("s/a.inc", "#include \"lib.inc\" \"text with \\\" in it\" \"sky.png\"\n");
    folder.write("s/bare.inc", "");
    folder.write("s/sky.png", "\"a.pov\"");
    folder.write("lib/lib.inc", "#include \"scene.pov\"\n#include \"deep.inc\"");
    folder.write("share/include/deep.inc", "");
    folder.write("share/include/a.inc", "\"unused.inc\"");
    folder.write("share/include/unused.inc", "");
    SceneSearch search{
        folder.path + "/s", {"+A0.3", "+L" + folder.path + "/lib"}, folder.path + "/share"};
    auto files = files_of_scene("scene.pov", search);
    BOOST_TEST(names_of(files) == "scene.pov a.inc lib.inc deep.inc sky.png bare ");
    BOOST_TEST(files[1].path == folder.path + "/s/a.inc"); // found before the library's a.inc
    search.options.pop_back();
    BOOST_TEST(names_of(files_of_scene("scene.pov", search)) == "scene.pov a.inc sky.png bare ");
    BOOST_CHECK_THROW(files_of_scene("none.pov", search), InputError);
}

BOOST_AUTO_TEST_CASE(settings_name_their_files)
{
    const Folder folder;
    folder.write("s/scene.ini",
                 "Input_File_Name=scene.pov ; the scene\nLibrary_Path = \"../lib\"\n");
    folder.write("s/scene.pov", "#include \"lib.inc\"");
    folder.write("lib/lib.inc", "");
    folder.write("s/more.ini", "Declare=Map=\"map.png\"\n");
    folder.write("s/map.png", "");
    folder.write("s/povray.ini", "");
    const SceneSearch search{folder.path + "/s", {"more.ini[part]"}, folder.path + "/share"};
    BOOST_TEST(names_of(files_of_scene("scene.ini", search)) ==
               "povray.ini more.ini map.png scene.ini scene.pov lib.inc ");
}

BOOST_AUTO_TEST_CASE(records_come_back)
{
    const Folder folder;
    const std::string path = folder.path + "/r.json";
    BOOST_TEST(int(read_record(path).state) == int(StepState::none));
    StepRecord record;
    record.state = StepState::done;
    record.starts = 3;
    record.inputs = "in";
    record.output = "out";
    record.bytes = 3e9;
    record.seconds = 0.1;
    record.error = 1.0 / 3;
    record.reason = "a \"reason\"\xff";
    record.remark = "a remark";
    write_record(path, record);
    const StepRecord back = read_record(path);
    BOOST_TEST(int(back.state) == int(StepState::done));
    BOOST_TEST(back.starts == 3);
    BOOST_TEST(back.bytes == 3e9);
    BOOST_TEST(back.seconds == 0.1);
    BOOST_TEST(*back.error == 1.0 / 3);
    BOOST_TEST(back.reason.substr(0, 10) == "a \"reason\"");
    BOOST_TEST(back.remark == "a remark");
    const std::string earlier = read_file(path); // becomes a record of an older version
    const auto comma = earlier.find(",\n \"remark\"");
    BOOST_REQUIRE(comma != std::string::npos);
    write_file(path, earlier.substr(0, comma) + "\n}\n");
    BOOST_TEST(read_record(path).starts == 3);
    BOOST_TEST(read_record(path).remark == "");
    const std::string deep = earlier.substr(0, comma) + ",\n\"x\": " + std::string(10000, '[') +
                             std::string(10000, ']') + "}";
    for (const std::string& broken : {std::string(), std::string("{"), std::string("[]"),
                                      std::string("{\"state\": 3}"), std::string("null"), deep}) {
        write_file(path, broken);
        BOOST_TEST(int(read_record(path).state) == int(StepState::none), broken.substr(0, 100));
        BOOST_TEST(read_record(path).starts == 0, broken.substr(0, 100));
    }
}

/// A batch's folder with one step.
struct OneStep {
    Folder folder;
    BatchStep step;
    BatchFolder batch;

    OneStep() : step(named()), batch(make_batch_folder(folder.path + "/out", plan_of(step))) {}

    static BatchStep named()
    {
        BatchStep step;
        step.name = "frame.a";
        step.output = "frames/a.png";
        return step;
    }
    static BatchPlan plan_of(const BatchStep& step)
    {
        BatchPlan plan;
        plan.steps.push_back(step);
        return plan;
    }
};

BOOST_AUTO_TEST_CASE(published_between_record_and_place)
{
    const OneStep one;
    const BatchStep& step = one.step;
    const BatchFolder& batch = one.batch;
    std::filesystem::create_directories(batch.work(step));
    write_file(batch.made(step), "picture");
    StepRecord record;
    record.inputs = "i";
    publish(batch, step, record);
    record = read_record(batch.record(step));
    BOOST_TEST(is_done(batch, step, record, "i"));
    BOOST_TEST(!is_done(batch, step, record, "j"));
    // Killed after the record is written, before the rename.
    std::filesystem::rename(batch.output(step), batch.made(step));
    BOOST_TEST(is_done(batch, step, record, "i"));
    BOOST_TEST(read_file(batch.output(step)) == "picture");
    write_file(batch.output(step), "Picture");
    BOOST_TEST(!is_done(batch, step, record, "i"));
    std::filesystem::remove(batch.output(step));
    BOOST_TEST(!is_done(batch, step, record, "i"));
}

BOOST_AUTO_TEST_CASE(published_while_another_looks)
{
    // A process that waits for a step renames its output itself if it finds the record before the
    // other process has done so. Neither process must fail.
    const OneStep one;
    const BatchStep& step = one.step;
    const BatchFolder& batch = one.batch;
    int failures = 0;
    for (int round = 0; round < 100; ++round) {
        const std::string inputs = std::to_string(round);
        const pid_t child = fork();
        if (child == 0) {
            alarm(60);
            try {
                while (!is_done(batch, step, read_record(batch.record(step)), inputs))
                    ;
                _exit(0);
            } catch (const OutputError&) {
                _exit(1);
            }
        }
        StepRecord record;
        record.inputs = inputs;
        try {
            std::filesystem::create_directories(batch.work(step));
            write_file(batch.made(step), inputs);
            publish(batch, step, record);
        } catch (const OutputError&) {
            ++failures;
        }
        int status = 1;
        waitpid(child, &status, 0);
        failures += status != 0;
        BOOST_TEST(read_file(batch.output(step)) == inputs);
    }
    BOOST_TEST(failures == 0);
}

BOOST_AUTO_TEST_CASE(only_whole_pictures)
{
    const Folder folder;
    const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
    folder.write("a.png", "......." + end);
    folder.write("b.png", "......." + end.substr(0, 11));
    folder.write("c.png", "");
    const Image picture = make_image<float>(40, 30, 3, Encoding{Encoding::Kind::linear, 1});
    write_frame(folder.path + "/a.exr", {picture, std::nullopt});
    const std::string exr = read_file(folder.path + "/a.exr");
    BOOST_TEST(is_whole(folder.path + "/a.exr"));
    for (const std::size_t size :
         {std::size_t(0), std::size_t(5), exr.size() / 2, exr.size() - 1}) {
        folder.write("b.exr", exr.substr(0, size));
        BOOST_TEST(!is_whole(folder.path + "/b.exr"), size);
    }
    BOOST_TEST(is_whole(folder.path + "/a.png"));
    BOOST_TEST(!is_whole(folder.path + "/b.png"));
    BOOST_TEST(!is_whole(folder.path + "/c.png"));
    BOOST_TEST(!is_whole(folder.path + "/d.png"));
}

BOOST_AUTO_TEST_CASE(one_holder_of_a_lock)
{
    const Folder folder;
    const std::string path = folder.path + "/lock";
    std::string holder;
    LockFile first, second;
    BOOST_REQUIRE(first.take(path, holder));
    BOOST_TEST(!second.take(path, holder));
    BOOST_TEST(holder == "process " + std::to_string(getpid()) + " on " + host_name());
    first.release();
    BOOST_TEST(second.take(path, holder));
    second.release();
    BOOST_TEST(!std::filesystem::exists(path));
    // A process is killed while it holds the lock.
    const pid_t child = fork();
    if (child == 0) {
        LockFile lock;
        std::string nobody;
        _exit(lock.take(path, nobody) ? 0 : 1);
    }
    int status = 1;
    BOOST_REQUIRE(waitpid(child, &status, 0) == child);
    BOOST_REQUIRE(status == 0);
    BOOST_TEST(std::filesystem::exists(path));
    BOOST_TEST(first.take(path, holder));
}

BOOST_AUTO_TEST_CASE(locks_of_other_namespaces_are_judged_by_age)
{
    const Folder folder;
    const std::string path = folder.path + "/lock";
    std::string holder;
    LockFile lock;
    BOOST_REQUIRE(lock.take(path, holder));
    const std::string own = read_file(path);
    const auto replaced = [&](const std::string& part, const std::string& with) {
        std::string text = own;
        BOOST_REQUIRE(text.find(part) != std::string::npos);
        return text.replace(text.find(part), part.size(), with);
    };
    const std::string process = "\"process\":" + std::to_string(getpid()),
                      name_space = "\"namespace\":\"" + process_namespace() + "\"";
    // Locks of a process that does not exist: in this namespace, in another, and in the older
    // format without a namespace.
    lock.release();
    write_file(path, replaced(process, "\"process\":4194305"));
    BOOST_TEST(lock.take(path, holder));
    lock.release();
    for (const std::string& other :
         {replaced(name_space, "\"namespace\":\"1\""), replaced("," + name_space, "")}) {
        write_file(path, other);
        BOOST_TEST(!lock.take(path, holder), other);
        BOOST_TEST(holder == "process " + std::to_string(getpid()) + " on " + host_name());
        made_ago(path, std::chrono::seconds(LockFile::seconds_of_silence + 10));
        BOOST_TEST(lock.take(path, holder), other);
        // A process with the same number in another namespace holds the lock: it must stay.
        write_file(path, other);
        lock.release();
        BOOST_TEST(std::filesystem::exists(path));
        std::filesystem::remove(path);
    }
}

BOOST_AUTO_TEST_CASE(what_killed_writers_leave_is_swept)
{
    const Folder folder;
    const auto unfinished = [&] {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path))
            if (entry.path().filename().string().rfind(".integral-", 0) == 0)
                names.push_back(entry.path().filename());
        return names;
    };
    // A process is killed, by a limit on the size of files, while it writes a file.
    const pid_t child = fork();
    if (child == 0) {
        const rlimit no_core{0, 0}, no_more{100, 100};
        std::signal(SIGXFSZ, SIG_DFL);
        setrlimit(RLIMIT_CORE, &no_core);
        setrlimit(RLIMIT_FSIZE, &no_more);
        write_file(folder.path + "/record", std::string(1000, 'x'));
        _exit(0);
    }
    BOOST_REQUIRE(child > 0);
    const auto end = [](pid_t process) { // waits, but leaves a zombie
        siginfo_t information;
        return waitid(P_PID, id_t(process), &information, WEXITED | WNOWAIT) == 0 &&
               information.si_code != CLD_EXITED;
    };
    BOOST_REQUIRE(end(child));
    BOOST_REQUIRE(unfinished().size() == 1);
    const std::string here = host_name() + "." + process_namespace() + ".";
    BOOST_TEST(unfinished()[0].substr(16) == "." + here + std::to_string(child));
    sweep_unfinished(folder.path);
    BOOST_TEST(unfinished().size() == 1); // a zombie still counts as a running process
    waitpid(child, nullptr, 0);
    sweep_unfinished(folder.path);
    BOOST_TEST(unfinished().empty());
    BOOST_TEST(!std::filesystem::exists(folder.path + "/record"));
    // Files that belong to another process, or may do so.
    const std::string of = ".integral-abcdef", number = std::to_string(child),
                      dead = "." + here + number,
                      elsewhere = of + "." + host_name() + ".1." + number;
    const std::vector<std::string> others = {unfinished_name("abcdef"),
                                             of + "." + here + "1",
                                             of + ".else" + here + number,
                                             elsewhere,
                                             of + "." + host_name() + "." + number,
                                             of,
                                             "notes" + dead,
                                             of + dead + ".json",
                                             of + dead + "x",
                                             of + "." + here,
                                             of + "." + here + "0",
                                             of + "." + here + "4294967296"};
    for (const std::string& name : others)
        folder.write(name, "");
    folder.write(".integral-lock" + dead, "");
    sweep_unfinished(folder.path);
    for (const std::string& name : others)
        BOOST_TEST(std::filesystem::exists(folder.path + "/" + name), name);
    BOOST_TEST(!std::filesystem::exists(folder.path + "/.integral-lock" + dead));
    // Whether a process of another namespace still runs cannot be found out; but no process writes
    // to one file for a whole day.
    const std::string forgotten = folder.path + "/" + elsewhere;
    made_ago(forgotten, std::chrono::hours(23));
    sweep_unfinished(folder.path);
    BOOST_TEST(std::filesystem::exists(forgotten));
    made_ago(forgotten, std::chrono::hours(25));
    sweep_unfinished(folder.path);
    BOOST_TEST(!std::filesystem::exists(forgotten));
    sweep_unfinished(folder.path + "/none");
}

BOOST_AUTO_TEST_CASE(many_processes_one_lock)
{
    // 8 processes add to one figure, 20 times each, under a lock; without it some additions would
    // be lost.
    const Folder folder;
    write_file(folder.path + "/figure", "0");
    std::vector<pid_t> children;
    for (int i = 0; i < 8; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            for (int round = 0; round < 20;) {
                LockFile lock;
                std::string holder;
                if (!lock.take(folder.path + "/lock", holder)) {
                    usleep(1000);
                    continue;
                }
                const int figure = std::atoi(read_file(folder.path + "/figure").c_str());
                usleep(500);
                write_file(folder.path + "/figure", std::to_string(figure + 1));
                ++round;
            }
            _exit(0);
        }
        children.push_back(child);
    }
    for (const pid_t child : children)
        BOOST_TEST(waitpid(child, nullptr, 0) == child);
    BOOST_TEST(read_file(folder.path + "/figure") == "160");
}

BOOST_AUTO_TEST_CASE(json_knows_its_lines)
{
    BOOST_TEST(refusal("{\"a\": [1,\n2], \"c\":\n 3}") ==
               "m.json:3: c: there is no such field; there are: a, b");
    BOOST_TEST(refusal("{\"a\": 1,\n\"a\": 2}") ==
               "m.json:2: the field a stands twice in one object");
    BOOST_TEST(refusal("{\"a\": {\"a\": 1}, \"b\": {\"a\": 2}}") == "");
    BOOST_TEST(refusal("{\n\"a\": 1,\n}").rfind("m.json:3: this is no JSON: ", 0) == 0);
    BOOST_TEST(refusal("[]") == "m.json:1: an object {...} is expected, of the fields a, b");
    BOOST_TEST(refusal("").rfind("m.json:1: this is no JSON: ", 0) == 0);
    BOOST_TEST(refusal("{\n\"a\": 1e999}") == "m.json:2: a number is out of range");
    BOOST_TEST(refusal("\n" + std::string(100000, '[')) ==
               "m.json:2: objects and lists are nested more than 64 deep; nest them less");
    const SourceJson root = SourceJson::parse(
        "m.json", "{ \"x/y\": [\n 1,\n 2\n\n], \"z\": {\n\n\"k\": \"v\" } }");
    BOOST_TEST(root.field("x/y").list()[1].line() == 3);
    BOOST_TEST(root.field("z").field("k").line() == 7);
    BOOST_TEST(root.field("z").line() == 5);
    BOOST_TEST(root.field("x/y").list()[1].whole(0, 5) == 2);
    BOOST_CHECK_THROW(root.field("x/y").list()[1].whole(3, 5), InputError);
    BOOST_CHECK_THROW(root.field("none"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
