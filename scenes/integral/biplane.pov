// SPDX-License-Identifier: AGPL-3.0-or-later
//
// biplane.pov -- a lenticular print with depth in front of, across and behind the sheet
//
// A stunt biplane over a sea of clouds: the near wing tip and the propeller come out of the paper, tail and far wing
// lie behind it, and clouds and peaks stand farther back. Parallax from side to side, as under every lenticular sheet.
//
//   povray-integral +Ibiplane.pov +W2400 +H1600 +Obiplane.png      (or: povray-integral biplane.ini)
//   integral replay biplane.png --eye 100,0,480 -o view.png
//
// Frame      2400 x 1600 pixels at 300 dpi = 203.2 x 135.5 mm, 160 lenses; 1200 x 800 is the same, half as large
// Sheet      lenticular, pitch 1.27 mm (15 pixels), thickness 3.08 mm, index 1.6, seen from 480 mm
// Scale      1 unit = 13.33 mm; the sheet is the plane z = 0
// Depth      wing tip -43 mm, wisp -35 mm, propeller -26 mm | far wing +25 mm, tail +38 mm, clouds +10 to +150 mm,
//            peaks +55 to +120 mm: far objects are large and soft, because at +100 mm a pixel is 4.4 mm wide
// Time       about 2 microseconds per pixel; +A0.1 +AM2 +R2 smooths the steps between lenses, in four times the time
//
#version 3.7;
global_settings { assumed_gamma 1.0  max_trace_level 6 }
#include "functions.inc"

#declare Eye   = <0, 0, -36>;
#declare Sheet = <0, 0, 0>;
#declare Window = 15.24;                                 // width at the sheet, units

camera {
  integral
  lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 }
  film { dpi 300 }
  location Eye  look_at Sheet
  right x*image_width/image_height  up y
  angle 2*degrees(atan2(Window/2, vlength(Sheet - Eye)))
}

// ---------------------------------------------------------------- light
light_source { <-44, 34, -66>*10 srgb <1.0, .93, .80>*1.2 }
light_source { <50, 2, -50>*10 srgb <.62, .66, .90>*.55 shadowless }
light_source { <30, -50, 10>*10 srgb <.75, .72, .9>*.45 shadowless }

light_source { <-70, 5, -30>*10 srgb <.70, .78, .98>*.5 shadowless }

// ---------------------------------------------------------------- paints
#declare Gloss = finish {
  ambient 0 diffuse .78 specular .7 roughness .03
  reflection { .03, .35 fresnel on } conserve_energy
}
#declare Satin = finish { ambient 0 diffuse .8 specular .2 roughness .06 }
#declare Red   = srgb <.80, .07, .05>;
#declare Cream = srgb <.98, .90, .72>;
#declare Paint_Red   = texture { pigment { Red }   finish { Gloss } }
#declare Paint_Cream = texture { pigment { Cream } finish { Gloss } }
#declare Dark  = texture { pigment { srgb <.13, .12, .13> } finish { Satin } }
#declare Steel = texture {
  pigment { srgb <.72, .73, .76> }
  finish { ambient 0 diffuse .45 specular .7 roughness .02 metallic reflection { .25 metallic } }
}
#declare Leather = texture { pigment { srgb <.36, .19, .10> } finish { Satin } }

// ---------------------------------------------------------------- skins
// Skin(P): a smooth mesh through the grid P[row][column], closed around the columns.
#macro Skin(P)
  #local N = dimension_size(P, 1);
  #local M = dimension_size(P, 2);
  mesh2 {
    vertex_vectors { N*M
      #for (I, 0, N-1) #for (J, 0, M-1) , P[I][J] #end #end }
    normal_vectors { N*M
      #for (I, 0, N-1) #for (J, 0, M-1)
        #local U = P[min(I+1, N-1)][J] - P[max(I-1, 0)][J];
        #local V = P[I][mod(J+1, M)] - P[I][mod(J+M-1, M)];
        #local C = vcross(U, V);
        , #if (vlength(C) > 1e-9) vnormalize(C) #else vnormalize(U + 1e-6*y) #end
      #end #end }
    face_indices { 2*(N-1)*M
      #for (I, 0, N-2) #for (J, 0, M-1)
        #local A = I*M + J;
        #local B = I*M + mod(J+1, M);
        , <A, B, A+M>, <B, B+M, A+M>
      #end #end }
    inside_vector y
  }
#end

// Wing: elliptic-tipped, cambered; span along x, leading edge towards -z.
#macro Wing(Span, Chord, Thick, Dihedral)
  #local N = 48; #local M = 32;
  #local P = array[N+1][M];
  #for (I, 0, N)
    #local S = -cos(pi*I/N);
    #local C = Chord*max(1e-3, pow(1 - pow(abs(S), 7), 1/2.2));
    #for (J, 0, M-1)
      #local A = 2*pi*J/M;
      #local T = (1 - cos(A))/2;                    // 0 leading edge .. 1 trailing edge
      #local Side = sin(A)/max(.25, abs(sin(A)))*(sin(A) > 0 ? 1 : .45);     // upper face thicker than the lower
      #local Y = Thick*C*(1.5*sqrt(T)*(1 - T) + .03)*Side + .10*C*T*(1 - T);
      #local P[I][J] = <S*Span/2, Y + abs(S)*Span/2*Dihedral, (T - .42)*C>;
    #end
  #end
  Skin(P)
#end

// Body: sections of half width, height above and below, by splines along z.
#declare Body_Size = spline { natural_spline          // at a distance from the cowling: <width, up, down>
  0.0, <.93, .93, .93>, 0.8, <.95, .96, .96>, 2.0, <.86, .93, .98>, 3.2, <.74, .90, .92>,
  4.4, <.58, .74, .74>, 5.8, <.36, .50, .48>, 7.2, <.17, .34, .26>, 8.1, <.05, .22, .12>
}
#declare Body = 
  #local N = 60; #local M = 40;
  #local P = array[N+1][M];
  #for (I, 0, N)
    #local Z = -2.0 + 8.1*I/N;
    #local B = Body_Size(Z + 2.0);
    #for (J, 0, M-1)
      #local A = 2*pi*J/M;
      #local E = .86;                               // a little squarer than an ellipse
      #local Ca = cos(A); #local Sa = sin(A);
      #local P[I][J] = <B.x*(Ca < 0 ? -1 : 1)*pow(abs(Ca), E),
        (Sa > 0 ? B.y : -B.z)*pow(abs(Sa), E), Z>;
    #end
  #end
  Skin(P)

// A streamlined strut from A to B.
#macro Strut(A, B)
  cylinder { 0, y, 1 matrix <.055, 0, 0, B.x-A.x, B.y-A.y, B.z-A.z, 0, 0, .13, A.x, A.y, A.z> }
#end

// ---------------------------------------------------------------- the aeroplane: nose -z, up y
#declare Stripe = function(x, y, z) { abs(x)/5.6 + .10*z }
#declare Ribs = normal { gradient x .10 slope_map { [0 <0, 0>] [.5 <.3, 0>] [1 <0, 0>] } scale .36 }
#declare Wing_Paint = texture {
  pigment { function { Stripe(x, y, z) } color_map {
    [.62 Red] [.62 Cream] [.70 Cream] [.70 Red] [.76 Red] [.76 Cream] [.84 Cream] [.84 Red] } }
  normal { Ribs }
  finish { Gloss }
}
#declare Body_Paint = texture {                          // a cream flash that narrows towards the tail
  pigment { function { min(.99, .5*abs(y + .05 - .035*z)/(.32 - .045*z)) } color_map { [.5 Cream] [.5 Red] } }
  finish { Gloss }
}

#declare Upper = object { Wing(11.6, 1.85, .13, .012) translate <0, 1.95, -.75> }
#declare Lower = object { Wing(10.6, 1.65, .13, .035) translate <0, -.62, .05> }

#declare Wheel = union {
  torus { .42, .17 rotate 90*z texture { Dark } }
  sphere { 0, 1 scale <.13, .40, .40> texture { Paint_Cream } }
  sphere { 0, 1 scale <.17, .12, .12> texture { Paint_Red } }
}

#declare Engine = union {
  lathe { bezier_spline 12                               // cowling ring
    <.80, -2.75> <.90, -2.95> <1.06, -2.90> <1.10, -2.70>
    <1.10, -2.70> <1.16, -2.40> <1.14, -2.00> <1.04, -1.72>
    <1.04, -1.72> <.95, -2.0> <.86, -2.4> <.80, -2.75>
    rotate 90*x
    texture { Paint_Cream }
  }
  cylinder { <0, 0, -2.0>, <0, 0, -1.9>, .95 texture { Dark } }
  #for (I, 0, 6)
    union {
      #for (K, 0, 4) cylinder { <0, .36+.11*K, -2.38>, <0, .41+.11*K, -2.38>, .2-.012*K } #end
      cylinder { <0, .3, -2.38>, <0, .85, -2.38>, .13 }
      rotate (I + .5)*360/7*z texture { Steel }
    }
  #end
  sphere { 0, 1 scale <.42, .42, .5> translate -2.4*z texture { Dark } }
}

#declare Blade = 
  #local N = 24; #local M = 16;
  #local P = array[N+1][M];
  #for (I, 0, N)
    #local T = I/N;
    #local C = .30*pow(max(0, 1 - pow(T, 6)), .5)*(.55 + 1.1*T - .75*T*T) + .002;
    #local Q = radians(62 - 44*T);
    #for (J, 0, M-1)
      #local A = 2*pi*J/M;
      #local X = C*cos(A); #local Z = C*.16*sin(A);
      #local P[I][J] = <X*cos(Q) - Z*sin(Q), .12 + 1.85*T, X*sin(Q) + Z*cos(Q)>;
    #end
  #end
  Skin(P)

#declare Propeller = union {
  #for (I, 0, 1)
    object { Blade
      texture {
        pigment { gradient y color_map { [.86 srgb <.70, .40, .20>] [.86 srgb <1, .82, .25>] } scale 1.999 }
        finish { Gloss diffuse 1 emission .06 }
      }
      rotate 180*I*z }
  #end
  lathe { cubic_spline 7 <0, -1> <0, -.62> <.16, -.45> <.27, -.18> <.30, .1> <.30, .2> <.3, .4>     // spinner
    rotate 90*x texture { Steel } }
}

#declare Pilot = union {
  sphere { 0, 1 scale <.26, .30, .29> texture { Leather } }
  sphere { 0, 1 scale <.20, .25, .2> translate <0, -.06, -.12>
    pigment { srgb <.90, .66, .52> } finish { Satin } }
  #for (S, -1, 1, 2)
    cylinder { <.1*S, .03, -.30>, <.1*S, .03, -.2>, .085 texture { Steel } }
  #end
  cylinder { <0, -.8, .05>, <0, -.2, 0>, .36 texture { Leather } }
  torus { .23, .1 translate -.30*y texture { Paint_Cream } }
  sphere_sweep { b_spline 8                              // scarf
    <.1, -.3, 0>, .1  <.15, -.26, .2>, .1  <.22, -.16, .5>, .1  <.18, -.12, .9>, .11
    <.30, -.02, 1.3>, .11  <.22, .02, 1.7>, .1  <.3, .1, 2.0>, .08  <.3, .1, 2.3>, .05
    texture { Paint_Cream } }
}

#declare Biplane = union {
  object { Body                                           // with a hole for the cockpit
    clipped_by { cylinder { <0, .3, 2>, <0, 1.6, 2>, .44 inverse } } texture { Body_Paint } }
  cylinder { <0, .0, 2>, <0, .78, 2>, .45 open texture { Leather } }
  disc { <0, .25, 2>, y, .45 texture { Dark } }
  torus { .46, .07 translate <0, .8, 2> texture { Leather } }
  intersection {                                          // wind screen
    sphere { 0, .62 } sphere { 0, .59 inverse } plane { z, -.18 } plane { -y, 0 }
    translate <0, .74, 1.85>
    pigment { rgbf <.9, .97, 1, .85> } finish { specular .8 roughness .01 reflection .12 }
  }
  object { Pilot translate <0, 1.2, 2.05> }
  object { Engine }
  object { Propeller rotate 28*z translate -3.0*z }
  object { Upper texture { Wing_Paint } }
  object { Lower texture { Wing_Paint } }
  #for (S, -1, 1, 2)
    union {
      Strut(<4.1*S, -.40, -.45>, <4.2*S, 2.0, -1.2>)
      Strut(<4.1*S, -.40, .55>, <4.2*S, 2.0, -.2>)
      Strut(<4.1*S, -.40, .45>, <4.2*S, 2.0, -1.1>)
      Strut(<.66*S, .6, -.8>, <.95*S, 2.0, -1.25>)
      Strut(<.66*S, .6, .2>, <.95*S, 2.0, -.2>)
      Strut(<.66*S, .6, .2>, <.95*S, 2.0, -1.15>)
      Strut(<.62*S, -.7, -1.3>, <1.12*S, -1.75, -1.1>)
      Strut(<.62*S, -.7, -.2>, <1.12*S, -1.75, -1.0>)
      texture { Paint_Cream }
    }
    object { Wheel translate <1.25*S, -1.8, -1.05> }
  #end
  cylinder { <-1.2, -1.78, -1.05>, <1.2, -1.78, -1.05>, .06 texture { Dark } }
  object { Wing(4.2, 1.3, .07, 0) translate <0, .12, 5.35> texture { Paint_Red } }
  intersection {                                          // fin and rudder
    object { Wing(3.6, 1.5, .07, 0) rotate 90*z }
    box { <-1, -.05, -3>, <1, 3, 3> }
    matrix <1, 0, 0, 0, 1, .22, 0, 0, 1, 0, 0, 0> translate <0, .1, 5.45>
    pigment { gradient y color_map { [.42 Red] [.42 Cream] [.62 Cream] [.62 Red] } scale 2 } finish { Gloss }
  }
}

object { Biplane
  rotate -16*x rotate 21*z rotate -44*y
  scale <1.1, 1.1, .68>                                  // a little flattened, like a relief: sharper under a sheet
  translate <.9, .45, .25>
}

// ---------------------------------------------------------------- sea of clouds
// The landscape is not lit: its pigment depends on the angle to the sun, and no object casts a shadow on it.
#declare Sun = vnormalize(<-.75, .62, -.45>);
#declare Painted = finish { ambient 0 diffuse 0 emission 1 }
#declare Haze = srgb <.98, .83, .72>;
#declare Puff = function(x, y, z) { abs(2*f_noise3d(x, y, z) - 1) }
#declare Billow = function(x, z) {                        // rounded heaps with creases between them
  pow(min(1, 1.25*Puff(x, 1.7, z)), .75) + .42*pow(Puff(2.3*x+7, 0, 2.3*z+3), .8)
  + .2*Puff(5*x+1, 4, 5*z+5) + .09*Puff(10*x, 3, 10*z)
}
#declare Sea_W = 48; #declare Sea_L = 10.5; #declare Sea_H = 3.2;
height_field {
  function 600, 300 { .03 + .7*min(1.3, Billow(x*Sea_W*.17, y*15*.2)) }
  smooth
  translate <-.5, -.5, 0> scale <Sea_W, Sea_H, Sea_L>
  matrix <1, 0, 0, 0, 1, 0, 0, .50, 1, 0, -5.6, .5>
  pigment { gradient z scale 11.2 pigment_map {
    [.25 slope { Sun } color_map {
      [.35 srgb <.30, .40, .68>] [.55 srgb <.56, .60, .80>] [.72 srgb <.90, .80, .82>]
      [.88 srgb <1, .93, .84>] [1 srgb <1, .98, .94>] }]
    [.8 slope { Sun } color_map { [.35 srgb <.66, .62, .80>] [.62 srgb <.92, .78, .78>] [.9 srgb <1, .88, .76>] }]
    [1 Haze] } }
  finish { Painted }
}

// ---------------------------------------------------------------- peaks
#declare Ridge = function(x, z) { 1 - abs(2*f_noise3d(x, 3.3, z) - 1) }
#declare Rocks = function(x, z) { .42 + .42*Ridge(x, z) + .30*Ridge(x, z)*Ridge(2.3*x+4, 2.3*z) }
#declare Cone = function(x, z, a, b, r, h) { h*max(0, 1 - sqrt((x-a)*(x-a) + (z-b)*(z-b)*.5)/r) }
#declare Peaks = function(x, z) {
  max(max(Cone(x, z, .76, .45, .25, 1), Cone(x, z, .62, .62, .18, .62)),
      max(Cone(x, z, .20, .5, .2, .75), Cone(x, z, .40, .7, .15, .45)))
}
height_field {
  function 600, 200 { min(.99, .95*Peaks(x, y)*Rocks(x*13, y*4)) }
  smooth water_level .01
  translate <-.5, 0, -.5> scale <31, 11.2, 5> translate <0, -4.7, 6.6>
  pigment { function { min(1, max(0, (y + 2.9)/7.4)) } pigment_map {
    [.02 Haze]
    [.34 slope { Sun } color_map {
      [.40 srgb <.22, .34, .60>] [.52 srgb <.34, .44, .68>] [.62 srgb <.62, .62, .78>]
      [.72 srgb <1, .86, .74>] [.92 srgb <1, .97, .92>] }] } }
  finish { Painted }
}

// ---------------------------------------------------------------- wisps: soft cards, one of them before the sheet
#macro Wisp(Width, Height, Seed, Colour)
  #local Across = 1.5*Width/Height;
  disc { 0, z, 1
    pigment { function { max(0, min(1, (1 - x*x - y*y)
        *(2*f_noise3d(Across*x + Seed, 1.5*y, Seed) - .32 + .18*f_noise3d(2.7*Across*x, 4*y, Seed)))) }
      color_map { [.05 srgbt <1, 1, 1, 1>] [.9 Colour transmit .12] } }
    finish { Painted } no_shadow
    scale <Width, Height, 1> }
#end
object { Wisp(4.6, 1.3, 3, srgb <1, .97, .95>) translate <-4.3, -4.6, -2.6> }
object { Wisp(5.2, 1.2, 8, srgb <1, .95, .90>) translate <5.9, -3.6, 2.2> }
object { Wisp(4.2, 1.0, 5, srgb <1, .94, .88>) translate <-6.1, -.4, 4.2> }
object { Wisp(6.2, 1.1, 13, srgb <1, .93, .86>) translate <4.4, 4.2, 5.2> }
object { Wisp(5.4, .8, 21, srgb <1, .93, .86>) translate <-6.8, 4.5, 6.2> }

disc { 0, z, 1                                          // mist where the clouds end
  pigment { spherical color_map { [0 Haze transmit 1] [.7 Haze] } }
  finish { Painted } no_shadow  scale <34, 1.6, 1> translate <0, -1.4, 8.4>
}

sky_sphere { pigment { function { max(0, y + .02) } color_map {
  [0 Haze] [.05 srgb <.95, .85, .78>] [.12 srgb <.60, .77, .88>]
  [.24 srgb <.20, .47, .76>] [1 srgb <.05, .18, .5>] } } }
