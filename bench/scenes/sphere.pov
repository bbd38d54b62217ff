// SPDX-License-Identifier: AGPL-3.0-or-later
// The thesis's table 4-1: a solid blue sphere, its centre 50 mm behind the sheet, before a plain
// wall of light.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "viewpoint.inc"
// "Depth -50mm" (section 4.3.2) is taken as 50 mm behind the sheet. That chapter counts depth
// towards the viewer: by equation 4-7 the object is view_dist - obj_dist from the viewer, and
// 4.3.7's patterns at 0 to 35 mm are "all forward of the lens sheet". Also, section 4.2 finds edges
// reduced to a jagged staircase on objects behind the screen, and hardly on objects in front of it.
light_source { <-200, 300, -400> rgb 1 }
background { rgb 0.85 }
// The thesis does not give the sphere's size. With this one, its image on the sheet, as seen from
// the eye, has about 0.57 of the film's width.
#ifndef (Sphere_Radius) #declare Sphere_Radius = 0.4*Film_Width; #end
sphere { <0, 0, 50>, Sphere_Radius pigment { rgb <0.05, 0.1, 0.8> } finish { ambient 0.35 diffuse 0.65 } }
