// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/first_steps.h"

namespace integral {

const char* first_steps()
{
    return R"steps(From SCENE.pov (any scene of POV-Ray's) to
  a look:  povray-integral +ISCENE.pov +W600 +H400 Integral_Camera="$(integral sheet --lpi 20 --camera --distance 300)"
           integral replay SCENE.png --html SCENE.html
  a print: integral sheet --list --print 150x100 --distance 400 --dpi 720    (choose the lens sheet; here 60 lenses an inch)
           povray-integral +ISCENE.pov Integral_Camera="$(integral sheet --lpi 60 --dpi 720 --print 150x100 --distance 400 --camera)"
           integral print SCENE.png -o page.pdf    (first measure the sheet: integral print --chart)
  a panel: povray-integral +ISCENE.pov Integral_Panel=looking-glass-go    (integral lcd --list: the panels)
           integral lcd SCENE.png --panel looking-glass-go -o panel.png
integral help lists all commands; doc/guide.md explains them. Integral_Draft=3 gives a quick look at the same print or panel.
)steps";
}

} // namespace integral
