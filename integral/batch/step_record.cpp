// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/step_record.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"

namespace integral {

const char* name_of(StepState state)
{
    switch (state) {
    case StepState::running: return "running";
    case StepState::done: return "done";
    case StepState::failed: return "failed";
    case StepState::none: break;
    }
    return "none";
}

StepRecord read_record(const std::string& path)
{
    StepRecord record;
    try {
        const Json json = parse_json(read_file(path));
        const std::string state = json.at("state");
        for (const StepState one : {StepState::running, StepState::done, StepState::failed})
            if (state == name_of(one))
                record.state = one;
        record.starts = json.at("starts");
        record.inputs = json.at("inputs");
        record.output = json.at("output");
        record.bytes = json.at("bytes");
        record.seconds = json.at("seconds");
        record.memory = json.at("memory_bytes");
        record.pixels = json.at("pixels");
        record.render_seconds = json.at("render_seconds");
        if (!json.at("error_rms").is_null())
            record.error = json.at("error_rms").get<double>();
        record.finished = json.at("finished");
        record.host = json.at("host");
        record.reason = json.at("reason");
        record.remark = json.value("remark", ""); // earlier records have none
    } catch (const InputError&) {
        return {};
    } catch (const JsonError&) {
        return {};
    } catch (const Json::exception&) {
        return {};
    }
    return record;
}

void write_record(const std::string& path, const StepRecord& record)
{
    const Json json = {{"state", name_of(record.state)},
                       {"starts", record.starts},
                       {"inputs", record.inputs},
                       {"output", record.output},
                       {"bytes", record.bytes},
                       {"seconds", record.seconds},
                       {"memory_bytes", record.memory},
                       {"pixels", record.pixels},
                       {"render_seconds", record.render_seconds},
                       {"error_rms", record.error ? Json(*record.error) : Json(nullptr)},
                       {"finished", record.finished},
                       {"host", record.host},
                       {"reason", record.reason},
                       {"remark", record.remark}};
    write_file(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace integral
