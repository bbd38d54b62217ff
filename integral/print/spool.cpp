// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/spool.h"

#include "integral/base/file_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#ifdef HAVE_CUPS
#include "integral/print/spool_document.h"

#include <cups/cups.h>

#include <chrono>
#include <memory>
#include <sstream>
#include <strings.h>
#include <thread>
#endif

namespace integral {

#ifdef HAVE_CUPS

bool can_spool() { return true; }

namespace {

using Server = std::unique_ptr<http_t, void (*)(http_t*)>;
using Message = std::unique_ptr<ipp_t, void (*)(ipp_t*)>;
using Clock = std::chrono::steady_clock;

constexpr int total_steps = 1000, sent_steps = 500;
constexpr auto poll_interval = std::chrono::milliseconds(200);

/// The options that would place or scale pages.
const char* const scaling_options[] = {"fit-to-page",     "fitplot",
                                       "landscape",       "media",
                                       "mirror",          "natural-scaling",
                                       "number-up",       "orientation-requested",
                                       "PageRegion",      "PageSize",
                                       "position",        "ppi",
                                       "print-scaling",   "printer-resolution",
                                       "Resolution",      "scaling",
                                       "StpiShrinkOutput"};

Server connect()
{
    Server server(httpConnect2(cupsServer(), ippPort(), nullptr, AF_UNSPEC, cupsEncryption(), 1,
                               30000, nullptr),
                  httpClose);
    if (!server)
        throw OutputError(std::string("CUPS server ") + cupsServer() + ": does not answer (" +
                          cupsLastErrorString() +
                          "); start cupsd, or name another server in CUPS_SERVER");
    return server;
}

std::string printer_uri(const std::string& printer)
{
    char uri[HTTP_MAX_URI];
    httpAssembleURIf(HTTP_URI_CODING_ALL, uri, sizeof uri, "ipp", nullptr, "localhost", 0,
                     "/printers/%s", printer.c_str());
    return uri;
}

/// Requests these attributes of a printer, or of one of its jobs, from the server.
Message ask(http_t* server, ipp_op_t operation, const std::string& printer, int job,
            const std::vector<const char*>& attributes)
{
    ipp_t* request = ippNewRequest(operation);
    if (!printer.empty())
        ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_URI, "printer-uri", nullptr,
                     printer_uri(printer).c_str());
    if (job)
        ippAddInteger(request, IPP_TAG_OPERATION, IPP_TAG_INTEGER, "job-id", job);
    ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_NAME, "requesting-user-name", nullptr,
                 cupsUser());
    ippAddStrings(request, IPP_TAG_OPERATION, IPP_TAG_KEYWORD, "requested-attributes",
                  int(attributes.size()), nullptr, attributes.data());
    return Message(cupsDoRequest(server, request, "/"), ippDelete); // frees the request
}

/// An attribute's values as text; "" if the answer lacks it.
std::string text_of(const Message& answer, const char* name)
{
    ipp_attribute_t* attribute = ippFindAttribute(answer.get(), name, IPP_TAG_ZERO);
    char text[1024] = "";
    if (attribute)
        ippAttributeString(attribute, text, sizeof text);
    return text;
}

int integer_of(const Message& answer, const char* name)
{
    ipp_attribute_t* attribute = ippFindAttribute(answer.get(), name, IPP_TAG_ZERO);
    return attribute ? ippGetInteger(attribute, 0) : 0;
}

/// A printer's message and reasons in one line, without the reason "none".
std::string reasons_of(const std::string& message, const std::string& reasons)
{
    std::string words = message;
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; },
        ' ');
    if (!reasons.empty() && reasons != "none")
        words += (words.empty() ? "" : ", ") + reasons;
    return words.empty() ? "no reason given" : words;
}

/// Whether one of the printer-state-reasons, joined by commas, needs a person's help. Reasons
/// without the ending -warning or -report are errors. Warnings and reports (a supply is low) do not
/// need help, except for those at which printers stop; nor do the reasons of CUPS' own backends.
bool in_trouble(const std::string& reasons)
{
    const auto begins = [](const std::string& word, const char* with) {
        return word.rfind(with, 0) == 0;
    };
    const auto ends = [](const std::string& word, const std::string& with) {
        return word.size() >= with.size() &&
               word.compare(word.size() - with.size(), with.size(), with) == 0;
    };
    std::istringstream list(reasons);
    for (std::string reason; std::getline(list, reason, ',');) {
        if (begins(reason, "media-empty") || begins(reason, "media-needed") ||
            begins(reason, "offline"))
            return true;
        if (reason != "none" && !begins(reason, "cups-") && !ends(reason, "-warning") &&
            !ends(reason, "-report"))
            return true;
    }
    return false;
}

std::vector<std::string> printers_of(http_t* server)
{
    std::vector<std::string> names;
    const Message answer = ask(server, IPP_OP_CUPS_GET_PRINTERS, "", 0, {"printer-name"});
    if (cupsLastError() > IPP_STATUS_OK_CONFLICTING &&
        cupsLastError() != IPP_STATUS_ERROR_NOT_FOUND)
        throw OutputError(std::string("CUPS server ") + cupsServer() + ": " +
                          cupsLastErrorString());
    for (ipp_attribute_t* each =
             answer ? ippFindAttribute(answer.get(), "printer-name", IPP_TAG_NAME) : nullptr;
         each; each = ippFindNextAttribute(answer.get(), "printer-name", IPP_TAG_NAME))
        names.emplace_back(ippGetString(each, 0, nullptr));
    std::sort(names.begin(), names.end());
    const char* usual = cupsGetDefault2(server);
    if (usual && std::find(names.begin(), names.end(), usual) != names.end())
        std::rotate(names.begin(), std::find(names.begin(), names.end(), usual),
                    std::find(names.begin(), names.end(), usual) + 1);
    return names;
}

/// Name of the queue `requested`, or of the default. Throws OutputError if there is no such queue,
/// or if it takes no jobs now.
std::string ready_printer(http_t* server, const std::string& requested)
{
    const std::vector<std::string> names = printers_of(server);
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    const std::string help = "; the CUPS server has " +
                             (names.empty() ? "no printer, lpadmin adds one" : list);
    const char* usual = cupsGetDefault2(server);
    if (requested.empty() && !usual)
        throw OutputError("the CUPS server has no default printer" + help);
    const std::string printer = requested.empty() ? usual : requested;
    if (std::find(names.begin(), names.end(), printer) == names.end())
        throw OutputError(printer + ": no such printer" + help);
    const Message state = ask(server, IPP_OP_GET_PRINTER_ATTRIBUTES, printer, 0,
                              {"printer-state", "printer-state-message", "printer-state-reasons",
                               "printer-is-accepting-jobs"});
    const std::string reasons = reasons_of(text_of(state, "printer-state-message"),
                                           text_of(state, "printer-state-reasons"));
    if (integer_of(state, "printer-state") == IPP_PSTATE_STOPPED)
        throw OutputError(printer + ": the printer is stopped (" + reasons + "); cupsenable " +
                          printer + " starts it");
    if (text_of(state, "printer-is-accepting-jobs") == "false")
        throw OutputError(printer + ": the printer rejects jobs (" + reasons + "); cupsaccept " +
                          printer + " lets it take them");
    return printer;
}

/// A job on the server. The destructor cancels the job unless it is done.
class SentJob {
public:
    SentJob(http_t* server, std::string printer, const std::string& title,
            const DriverOptions& options)
        : server_(server), printer_(std::move(printer))
    {
        cups_option_t* list = nullptr;
        int count = 0;
        for (const auto& [name, value] : options)
            count = cupsAddOption(name.c_str(), value.c_str(), count, &list);
        number = cupsCreateJob(server, printer_.c_str(), title.c_str(), count, list);
        cupsFreeOptions(count, list);
        if (!number)
            throw std::runtime_error(std::string("the CUPS server takes no job: ") +
                                     cupsLastErrorString());
    }
    ~SentJob()
    {
        // Connect again: this connection may be in the middle of sending the document.
        if (!done && httpReconnect2(server_, 5000, nullptr) == 0)
            cupsCancelJob2(server_, printer_.c_str(), number, 0);
    }
    SentJob(const SentJob&) = delete;
    SentJob& operator=(const SentJob&) = delete;

    int number = 0;
    bool done = false; ///< printed, or cancelled or aborted by the server

private:
    http_t* server_;
    std::string printer_;
};

/// Sends the document while producing it. Returns false if `progress` stopped it.
bool send(http_t* server, const std::string& printer, int number, const std::string& title,
          const SpoolDocument& document, int copies, const Progress& progress)
{
    constexpr double piece = 1 << 18; // bytes from one call of progress to the next
    const Image& first = document.sheets.front();
    const double total = 3.0 * first.width * first.height * double(document.sheets.size()) * copies;
    double sent = 0, next_call = 0;
    bool is_stopped = false;
    http_status_t status = cupsStartDocument(server, printer.c_str(), number, title.c_str(),
                                             "application/vnd.cups-raster", 1);
    const auto take = [&](const char* bytes, std::size_t count) {
        if (progress && sent >= next_call) {
            next_call = sent + piece;
            is_stopped = !progress(int(std::min(1.0, sent / total) * sent_steps), total_steps);
        }
        if (!is_stopped)
            status = cupsWriteRequestData(server, bytes, count);
        sent += double(count);
        return !is_stopped && status == HTTP_STATUS_CONTINUE;
    };
    if (status == HTTP_STATUS_CONTINUE)
        write_cups_raster(document.sheets, copies, document.header, take);
    if (is_stopped)
        return false;
    if (status != HTTP_STATUS_CONTINUE ||
        cupsFinishDocument(server, printer.c_str()) > IPP_STATUS_OK_CONFLICTING)
        throw std::runtime_error(std::string("the CUPS server does not take the document: ") +
                                 cupsLastErrorString());
    return true;
}

/// The server's data on a job. Throws std::runtime_error if the server does not answer.
Message ask_about_job(http_t* server, const std::string& printer, int number)
{
    Message job = ask(server, IPP_OP_GET_JOB_ATTRIBUTES, printer, number,
                      {"job-state", "job-state-reasons", "job-printer-state-message",
                       "job-impressions-completed", "job-media-progress"});
    if (cupsLastError() > IPP_STATUS_OK_CONFLICTING)
        throw std::runtime_error(std::string("the CUPS server does not tell how the job goes: ") +
                                 cupsLastErrorString());
    return job;
}

/// Whether the job is printed. Throws std::runtime_error if it will not be.
bool is_printed(const Message& job, SentJob& sent)
{
    const int state = integer_of(job, "job-state");
    const std::string words = reasons_of(text_of(job, "job-printer-state-message"),
                                         text_of(job, "job-state-reasons"));
    if (state == IPP_JSTATE_COMPLETED) {
        sent.done = true;
        return true;
    }
    if (state == IPP_JSTATE_CANCELED || state == IPP_JSTATE_ABORTED) {
        sent.done = true;
        const char* end = state == IPP_JSTATE_CANCELED ? " was cancelled (" : " failed (";
        throw std::runtime_error("job " + std::to_string(sent.number) + end + words + ")");
    }
    if (state == IPP_JSTATE_STOPPED || state == IPP_JSTATE_HELD)
        throw std::runtime_error("job " + std::to_string(sent.number) + " was stopped (" + words +
                                 "); it is cancelled");
    return false;
}

/// Waits for the end of the job. Returns false if `progress` stopped it. Throws std::runtime_error
/// with the printer's reason.
bool follow(http_t* server, const std::string& printer, SentJob& sent, int sheets, double patience,
            const Progress& progress)
{
    int best = 0;
    Clock::time_point last_progress = Clock::now();
    for (;; std::this_thread::sleep_for(poll_interval)) {
        const Message job = ask_about_job(server, printer, sent.number);
        if (is_printed(job, sent)) {
            if (progress)
                progress(total_steps, total_steps);
            return true;
        }
        const Message device = ask(
            server, IPP_OP_GET_PRINTER_ATTRIBUTES, printer, 0,
            {"printer-state", "printer-state-message", "printer-state-reasons"});
        const std::string device_reasons = text_of(device, "printer-state-reasons");
        const std::string device_words = reasons_of(text_of(device, "printer-state-message"),
                                                    device_reasons);
        if (integer_of(device, "printer-state") == IPP_PSTATE_STOPPED)
            throw std::runtime_error("the printer was stopped (" + device_words +
                                     "); the job is cancelled");

        const double sheet_part = integer_of(job, "job-media-progress") / 100.0;
        const double part = std::min(
            1.0, (integer_of(job, "job-impressions-completed") + sheet_part) / sheets);
        const int steps = sent_steps + int(part * (total_steps - sent_steps - 1));
        if (steps > best) {
            best = steps;
            last_progress = Clock::now();
        }
        if (in_trouble(device_reasons) &&
            std::chrono::duration<double>(Clock::now() - last_progress).count() > patience)
            throw std::runtime_error("the printer does not go on (" + device_words +
                                     "); the job is cancelled");
        if (progress && !progress(best, total_steps))
            return false;
    }
}

} // namespace

std::vector<std::string> printers() { return printers_of(connect().get()); }

std::optional<int> spool(SpoolJob job, const Progress& progress)
{
    if (job.pages.empty() || job.copies < 1 || !(job.dpi.x > 0) || !(job.dpi.y > 0))
        throw std::invalid_argument("a print job needs pages, copies and a resolution");
    for (const Image& page : job.pages)
        if (page.channels != 3 || sample_bits(page) != 8 || page.width < 1 || page.height < 1 ||
            !same_form(page, job.pages.front()))
            throw std::invalid_argument("a print job's pages are 8-bit RGB and of one size");

    const Server server = connect();
    const std::string printer = ready_printer(server.get(), job.printer);
    for (const auto& [name, value] : job.options)
        for (const char* scales : scaling_options)
            if (strcasecmp(name.c_str(), scales) == 0)
                throw OutputError(printer + ": option " + name + "=" + value +
                                  " would place or scale the page anew; leave it out");
    try {
        const std::string title = job.title;
        const int copies = job.copies, sheets = int(job.pages.size()) * copies;
        const double patience = job.patience;
        const SpoolDocument document = spool_document(std::move(job), server.get(), printer);
        SentJob sent(server.get(), printer, title, document.options);
        if (!send(server.get(), printer, sent.number, title, document, copies, progress))
            return std::nullopt;
        if (!follow(server.get(), printer, sent, sheets, patience, progress))
            return std::nullopt;
        return sent.number;
    } catch (const std::runtime_error& error) {
        throw OutputError(printer + ": " + error.what());
    }
}

#else

namespace {

[[noreturn]] void no_cups()
{
    throw OutputError("this build has no libcups, so it cannot print; install libcups2-dev (a "
                      "package of Debian) and configure "
                      "again, or write a file");
}

} // namespace

bool can_spool() { return false; }

std::vector<std::string> printers() { no_cups(); }

std::optional<int> spool(SpoolJob, const Progress&) { no_cups(); }

#endif

} // namespace integral
