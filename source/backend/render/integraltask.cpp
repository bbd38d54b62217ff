// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integraltask.h"
#include "backend/scene/camera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

IntegralTask::IntegralTask(ViewData *view, bool counted)
    : RenderTask(view),
      counted(counted),
      cooperate(*this),
      trace(view, GetViewDataPtr(), view->GetSceneData()->parsedMaxTraceLevel,
            view->GetSceneData()->parsedAdcBailout, view->GetQualityFeatureFlags(), cooperate,
            media, radiosity),
      media(GetViewDataPtr(), &trace, &photons),
      radiosity(view->GetSceneData(), GetViewDataPtr(), view->GetSceneData()->radiositySettings,
                view->GetRadiosityCache(), cooperate, true, Vector3d(view->GetCamera().Location)),
      photons(&view->GetSceneData()->mediaPhotonMap, view->GetSceneData()->photonSettings)
{
    GetViewDataPtr()->qualityFlags = view->GetQualityFeatureFlags();
}

void IntegralTask::Finish()
{
    if (!counted)
        GetViewDataPtr()->Stats() = RenderStatistics();
    GetViewDataPtr()->timeType = counted ? SceneThreadData::kRenderTime
                                         : SceneThreadData::kUnknownTime;
    GetViewDataPtr()->realTime = ConsumedRealTime();
    GetViewDataPtr()->cpuTime = ConsumedCPUTime();
}

}
