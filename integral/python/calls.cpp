// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/python/calls.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/notices.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace integral {
namespace {

/// The notices of the call that this thread works for; null in other threads.
thread_local std::vector<std::string>* notices = nullptr;

/// A piece of work in a thread, and its state.
class Running {
public:
    /// The work's notices go to `notices_of_work`, which outlives this.
    Running(const std::function<void(const Progress&)>& work,
            std::vector<std::string>& notices_of_work)
        : thread_([this, &work, &notices_of_work] {
              notices = &notices_of_work;
              run(work);
          })
    {
    }
    ~Running()
    {
        stop();
        thread_.join();
    }

    void stop() { stopped_ = true; }

    /// Waits a while; returns true once the work has ended.
    bool wait()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        return changed_.wait_for(lock, std::chrono::milliseconds(100), [this] { return ended_; });
    }
    std::pair<int, int> progress()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return {done_, total_};
    }
    /// The exception of the work, once it has ended; null if there was none.
    std::exception_ptr error() const { return error_; }

private:
    void run(const std::function<void(const Progress&)>& work)
    {
        try {
            work([this](int done, int total) {
                const std::lock_guard<std::mutex> lock(mutex_);
                done_ = done;
                total_ = total;
                return !stopped_;
            });
        } catch (...) {
            error_ = std::current_exception();
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::atomic<bool> stopped_{false};
    bool ended_ = false;
    int done_ = 0, total_ = 0;
    std::exception_ptr error_;
    std::thread thread_; ///< the last member: it uses the others
};

/// Gives lines as Python warnings.
void give_warnings(const std::vector<std::string>& lines)
{
    constexpr int of_the_caller = 2; // beyond the module's own function in Python
    for (const std::string& line : lines)
        if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), of_the_caller) != 0)
            throw py::error_already_set();
}

PyObject* new_exception(const char* name, const char* doc, const py::object& bases)
{
    PyObject* const made = PyErr_NewExceptionWithDoc(name, doc, bases.ptr(), nullptr);
    if (!made)
        throw py::error_already_set();
    return made;
}

PyObject* input_error = nullptr;  // integral.InputError
PyObject* output_error = nullptr; // integral.OutputError

} // namespace

void run_long(const py::object& progress, const std::function<void(const Progress&)>& work)
{
    std::optional<py::error_already_set> raised;
    std::exception_ptr failure;
    std::vector<std::string> lines;
    {
        std::optional<py::gil_scoped_release> released(std::in_place);
        Running running(work, lines);
        while (!running.wait()) {
            released.reset();
            try {
                if (PyErr_CheckSignals() != 0)
                    throw py::error_already_set();
                const auto [done, total] = running.progress();
                if (!raised && !progress.is_none() && total > 0)
                    progress(done, total);
            } catch (py::error_already_set& error) {
                raised.emplace(std::move(error));
                running.stop();
            }
            released.emplace();
        }
        failure = running.error();
    }
    try {
        give_warnings(lines);
    } catch (const py::error_already_set&) { // warnings are errors; a failure goes first
        if (!raised && !failure)
            throw;
    }
    if (raised)
        throw std::move(*raised);
    if (failure)
        std::rethrow_exception(failure);
}

void declare_messages(py::module_& module)
{
    const py::handle value_error = PyExc_ValueError, os_error = PyExc_OSError;
    input_error = new_exception("integral.InputError",
                                "A file that cannot be read or is not valid. The message is "
                                "\"FILE: what is wrong; what would help\".",
                                py::make_tuple(value_error, os_error));
    output_error = new_exception("integral.OutputError",
                                 "A file that could not be written. An old file of that name is "
                                 "unchanged.",
                                 py::reinterpret_borrow<py::object>(os_error));
    module.attr("InputError") = py::handle(input_error);
    module.attr("OutputError") = py::handle(output_error);
    py::register_exception_translator([](std::exception_ptr error) {
        try {
            std::rethrow_exception(error);
        } catch (const InputError& e) {
            PyErr_SetString(input_error, e.what());
        } catch (const OutputError& e) {
            PyErr_SetString(output_error, e.what());
        } catch (const Interrupted&) {
            PyErr_SetNone(PyExc_KeyboardInterrupt);
        }
    });
    receive_notices([](const std::string& line) {
        if (notices)
            notices->push_back(line);
    });
}

} // namespace integral
