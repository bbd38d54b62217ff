// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/first_steps.h"

namespace integral {

const char* first_steps()
{
    return "From SCENE.pov (any scene of POV-Ray's) to\n"
           "  a look:  povray-integral +ISCENE.pov +W600 +H400 Integral_Camera=\"$(integral sheet "
           "--lpi 20 --camera --distance 300)\"\n"
           "           integral replay SCENE.png --html SCENE.html\n"
           "  a print: integral sheet --list --print 150x100 --distance 400 --dpi 720    (choose "
           "the "
           "lens sheet; here 60 lenses per inch)\n"
           "           povray-integral +ISCENE.pov +W4252 +H2835 Integral_Camera=\"$(integral "
           "sheet "
           "--lpi 60 --dpi 720 --camera --distance 400)\"\n"
           "           integral print SCENE.png -o page.pdf    (first measure the sheet: integral "
           "print --chart)\n"
           "  a panel: integral lcd --panel looking-glass-go --camera > panel.ini    (integral lcd "
           "--list: the panels)\n"
           "           povray-integral panel.ini +ISCENE.pov\n"
           "           integral lcd SCENE.png --panel looking-glass-go -o panel.png\n"
           "integral help lists all commands; doc/guide.md explains them.\n";
}

} // namespace integral
