// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralstripes.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

IntegralStripes::IntegralStripes(const integral::Subpixels& subpixels)
{
    if (subpixels != integral::Subpixels::rgb && subpixels != integral::Subpixels::bgr)
        return;
    number = 3;
    red = subpixels == integral::Subpixels::rgb ? 0 : 2;
}

std::shared_ptr<const integral::IntegralCamera> IntegralStripes::Camera_Of(
    const integral::IntegralCamera& camera) const
{
    if (number == 1)
        return nullptr;
    const auto stripes = std::make_shared<integral::IntegralCamera>(camera);
    stripes->film.width *= number;
    stripes->film.pixel_pitch.x /= number;
    stripes->film.subpixels = integral::Subpixels::none;
    return stripes;
}

integral::PictureBlock IntegralStripes::Of(const integral::PictureBlock& block) const
{
    return {block.left * number, block.top, block.right * number + number - 1, block.bottom};
}

void IntegralStripes::Merge(std::vector<Colour>& colours) const
{
    if (number == 1)
        return;
    std::size_t k = 0;
    for (std::size_t first = 0; first < colours.size(); first += number, k++)
    {
        const Colour stripes[] = {colours[first], colours[first + 1], colours[first + 2]};
        Colour& colour = colours[k];
        colour.clear();
        colour.red() = stripes[red].red();
        colour.green() = stripes[1].green();
        colour.blue() = stripes[2 - red].blue();
        for (const Colour& stripe : stripes)
        {
            colour.filter() += stripe.filter() / number;
            colour.transm() += stripe.transm() / number;
        }
    }
    colours.resize(k);
}

}
