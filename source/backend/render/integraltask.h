// SPDX-License-Identifier: AGPL-3.0-or-later
// The base class of the integral camera's tasks of a view. Each task has its own tracer.
#ifndef POVRAY_BACKEND_INTEGRALTASK_H
#define POVRAY_BACKEND_INTEGRALTASK_H

#include "backend/frame.h"
#include "backend/render/rendertask.h"
#include "backend/render/tracepixel.h"
#include "backend/lighting/photons.h"
#include "backend/lighting/radiosity.h"
#include "backend/interior/media.h"

namespace pov
{

class IntegralTask : public RenderTask
{
public:
    virtual void Stopped() {}
    virtual void Finish();

protected:
    /// `counted`: include the task's rays and time in POV-Ray's statistics of the frame.
    IntegralTask(ViewData *view, bool counted);

private:
    class CooperateFunction : public Trace::CooperateFunctor
    {
    public:
        explicit CooperateFunction(Task& t) : task(t) {}
        virtual void operator()() { task.Cooperate(); }

    private:
        Task& task;
    };

    bool counted;
    CooperateFunction cooperate;

protected:
    TracePixel trace;
    MediaFunction media;
    RadiosityFunction radiosity;

private:
    PhotonGatherer photons;
};

}

#endif
