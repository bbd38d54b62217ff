// SPDX-License-Identifier: AGPL-3.0-or-later
//
// skull.pov -- a still life in depth: glass, candle light and cast shadows under square lenses, upright format
//
// A vanitas: the skull's brow and teeth come up to the viewer, apple, scroll and table edge stand before the paper,
// candle and hourglass behind it, a velvet curtain at the back. Highlights and reflections move with the eye, too.
//
//   povray-integral +Iskull.pov +W1800 +H2400 +Oskull.png            (or: povray-integral skull.ini)
//   integral replay skull.png --eye -80,0,450 -o view.png
//
// Frame      1800 x 2400 pixels at 300 dpi = 152.4 x 203.2 mm, 136 x 181 lenses
// Sheet      square, pitch 1.124 mm (13.28 pixels), thickness 3.23 mm, index 1.675, seen from 450 mm
// Scale      1 unit = 10 mm; the sheet leans back by 5 degrees, near the plane z = 0
// Depth      apple -40 mm, table edge -39 mm, scroll -33 mm, face -20 mm | candle +32 mm, back of the skull and
//            hourglass +50 mm, curtain +70 to +100 mm
// Time       about 6 microseconds a pixel
//
#version 3.7;
global_settings { assumed_gamma 1.0  max_trace_level 6 }

#declare Eye    = <0, 4.0, -45>;
#declare Sheet  = <0, 0, 0>;
#declare Window = 15.24;                                 // width at the sheet, units

camera {
  integral
  lens_sheet { square pitch 1.124 thickness 3.23 ior 1.675 }
  film { dpi 300 }
  location Eye  look_at Sheet
  right x*image_width/image_height  up y
  angle 2*degrees(atan2(Window/2, vlength(Sheet - Eye)))
}

#declare Flame = <5.4, 1.9, 3.2>;
light_source { <-46, 44, -48>*4 srgb <1, .95, .86> }                                // a window, out of the frame
light_source { <50, 10, -60>*4 srgb <.62, .70, 1>*.3 shadowless }
light_source { Flame srgb <1, .62, .28>*2.2 fade_distance 5 fade_power 2 }          // the candle

#declare Satin = finish { ambient 0 diffuse .8 specular .2 roughness .05 }
#declare Bone = texture {
  pigment { bozo turbulence .4 scale .5 color_map {
    [0 srgb <.93, .86, .70>] [.5 srgb <.90, .81, .62>] [1 srgb <.80, .68, .48>] } }
  normal { granite .06 scale .8 }
  finish { ambient 0 diffuse .82 specular .18 roughness .04 }
}
#declare Hollow = texture { pigment { srgb <.24, .15, .09> } finish { ambient 0 diffuse .6 } }

// ---------------------------------------------------------------- skull: face -z, up y, half the cranium's width = 1
#macro Lump(P, R, S) sphere { 0, 1.414, S scale R translate P } #end
#macro Chain(A, Ra, B, Rb)
  #local L = vlength(B - A);
  #local T = 0;
  #while (T <= 1)
    #local R = Ra + (Rb - Ra)*T;
    sphere { A + (B - A)*T, 1.414*R, .42 }
    #local T = T + .45*R/L;
  #end
#end

#declare Cranium = difference {
  blob { threshold .25
    Lump(<0, .30, .32>, <.96, .84, 1.08>, 1)
    Lump(<0, .16, -.44>, <.72, .64, .56>, .75)
    Lump(<0, .30, .75>, <.86, .60, .60>, .3)
    Lump(<0, -.34, .45>, <.60, .36, .55>, .8)
    Lump(<0, -.42, -.42>, <.62, .46, .46>, .8)
    Lump(<0, -.98, -.78>, <.40, .28, .34>, 1)
    Chain(<0, -.24, -.98>, .14, <0, -.56, -1.13>, .10)
    #for (S, -1, 1, 2)
      Chain(<.10*S, -.12, -.86>, .15, <.56*S, -.10, -.74>, .15)
      Chain(<.60*S, -.12, -.68>, .15, <.65*S, -.54, -.70>, .13)
      Chain(<.13*S, -.30, -.94>, .12, <.24*S, -.80, -.94>, .12)
      Lump(<.54*S, -.66, -.80>, <.20, .14, .18>, .9)
      Chain(<.56*S, -.70, -.80>, .15, <.24*S, -.84, -.96>, .15)
      Chain(<.64*S, -.64, -.70>, .14, <.88*S, -.54, -.05>, .09)
      Lump(<.76*S, -.52, .28>, <.15, .26, .20>, .8)
      Lump(<.38*S, -.40, -1.22>, <.25, .22, .34>, -.7)
      Lump(<1.04*S, -.14, -.36>, <.18, .34, .30>, -.45)
    #end
    texture { Bone }
  }
  #for (S, -1, 1, 2)
    superellipsoid { <.8, .8> scale <.265, .235, .42> rotate <0, 12*S, -9*S> translate <.365*S, -.40, -.94> }
    sphere { 0, 1 scale <.09, .18, .35> rotate 24*S*z translate <.095*S, -.77, -1.08> }
  #end
  texture { Hollow }
}

#macro Arch(A, R, Z) <R*sin(A), 0, Z - R*cos(A)> #end       // of the teeth
#declare Teeth = union {
  #for (I, -6.5, 6.5)
    #local A = radians(I*13.5);
    #local W = .072 + .012*(abs(I) > 3);
    superellipsoid { <.6, .6> scale <W, .15 - .008*abs(I), .06>
      rotate -I*13.5*y translate Arch(A, .44, -.72) - 1.27*y }
    superellipsoid { <.6, .6> scale <W*.92, .14 - .005*abs(I), .055>
      rotate -I*13.5*y translate Arch(A, .41, -.70) - 1.51*y }
  #end
  texture { pigment { srgb <.95, .89, .74> } finish { Satin } }
}
#declare Mandible = blob { threshold .25
  #for (I, -6, 6)
    #local A = radians(I*15);
    Lump(Arch(A, .40, -.66) + <0, -1.76, 0>, <.14, .17, .14>, .5)
    Lump(Arch(A, .40, -.68) + <0, -1.62, 0>, <.10, .12, .10>, .4)
  #end
  Lump(<0, -1.93, -1.04>, <.26, .12, .12>, .9)
  #for (S, -1, 1, 2)
    #for (T, 0, 1, .125)
      Lump(<.42, -1.72, -.66>*<S, 1, 1> + T*<.36*S, .28, .72>, <.12, .19, .15>, .5)
      Lump(<.80*S, -1.45, .06> + T*<.07*S, .60, .06>, <.09, .17, .27 - .06*T>, .5)
    #end
    Chain(<.86*S, -.85, .14>, .14, <.88*S, -.56, .16>, .12)
    Chain(<.82*S, -.90, -.10>, .12, <.78*S, -.62, -.20>, .07)
  #end
  texture { Bone }
}
#declare Skull = union { object { Cranium } object { Teeth } object { Mandible } }

// ---------------------------------------------------------------- still life, 1 unit = 10 mm
#declare Gilt = texture {
  pigment { srgb <.90, .68, .30> }
  finish { ambient 0 diffuse .5 specular .8 roughness .03 metallic reflection { .2 metallic } }
}
#declare Gloss = finish {
  ambient 0 diffuse .8 specular .5 roughness .03 reflection { .02, .2 fresnel on } conserve_energy
}

// A closed book on its side: spine towards -z, lower left front corner at the origin.
#macro Book(W, H, D, Leather)
  union {
    intersection {                                      // pages
      box { <.12, .12, .1>, <W - .15, H - .12, D - .15> }
      cylinder { <-1, H/2, -.2>, <W + 1, H/2, -.2>, D }
      pigment { gradient y scale .22 color_map {
        [0 srgb <.93, .86, .70>] [.5 srgb <.80, .70, .52>] [1 srgb <.93, .86, .70>] } }
      finish { Satin }
    }
    union {
      box { <0, 0, 0>, <W, .14, D> }
      box { <0, H - .14, 0>, <W, H, D> }
      cylinder { <0, H/2, 0>, <W, H/2, 0>, H/2 scale <1, 1, .35> }
      #for (I, 1, 4) torus { H/2 + .01, .09 rotate 90*z scale <1.4, 1, .35> translate <I*W/5, H/2, -.02> } #end
      texture { Leather }
    }
    #for (I, 0, 1)
      union {
        cylinder { <.25 + I*(W - .5), H/2, 0>, <.32 + I*(W - .5), H/2, 0>, H/2 + .02 scale <1, 1, .36> }
        box { <.5, H, .35>, <W - .5, H + .012, .5> } box { <.5, H, D - .5>, <W - .5, H + .012, D - .35> }
        box { <.5 + I*(W - 1.15), H, .35>, <.65 + I*(W - 1.15), H + .012, D - .35> }
        texture { Gilt }
      }
    #end
  }
#end
#macro Leather(C) texture { pigment { C } normal { bumps .06 scale .25 } finish { Gloss } } #end

#declare Candle = union {
  lathe { cubic_spline 12                                // holder and its handle
    <0, -.1> <0, 0> <2.0, 0> <2.1, .2> <1.9, .38> <.75, .55> <.35, 1.0> <.55, 1.35>
    <.95, 1.6> <1.0, 1.8> <.85, 1.85> <0, 1.8>
    texture { Gilt } }
  torus { .55, .13 scale <1, 1.4, .6> rotate 90*x translate <2.2, .3, 1.9> texture { Gilt } }
  blob { threshold .25
    cylinder { <0, 1.7, 0>, <0, 5.9, 0>, .62*1.414, 1 }
    #local Rnd = seed(7);
    #for (I, 0, 8)
      #local A = 2*pi*I/9 + rand(Rnd)*.4;
      #local L = 1.0 + 2.4*rand(Rnd);
      cylinder { <.58*cos(A), 6.1 - L, .58*sin(A)>, <.56*cos(A), 6.15, .56*sin(A)>, .22, .7 }
      sphere { <.62*cos(A), 6.1 - L, .62*sin(A)>, .28, .8 }
    #end
    sphere { <0, 6.6, 0>, .6, -.6 }
    pigment { gradient y color_map { [.2 srgb <.98, .93, .80>] [1 srgb <1, .84, .52>] } scale 6.5 }
    finish { ambient 0 diffuse .75 emission .16 specular .3 roughness .05 }
  }
  cylinder { <0, 5.9, 0>, <.04, 6.75, 0>, .05 pigment { srgb .05 } }
  sphere { 0, 1 scale <.34, .95, .34>
    pigment { gradient y scale 1.95 translate -.97*y color_map {
      [0 srgb <.9, .35, .1> transmit .6] [.45 srgb <1, .85, .45>] [.75 srgb <1, .95, .75>] [1 srgb <1, .7, .25>] } }
    finish { ambient 0 diffuse 0 emission 1.5 } no_shadow
    translate <.03, 7.35, 0> }
}

#declare Hourglass = union {
  #for (S, -1, 1, 2)
    lathe { cubic_spline 9
      <0, -.3> <0, 0> <1.75, 0> <1.9, .15> <1.75, .32> <1.55, .4> <1.35, .55> <0, .55> <0, .8>
      scale <1, -S, 1> translate S*3.3*y
      texture { pigment { srgb <.30, .14, .06> } finish { Gloss } } }
  #end
  #for (I, 0, 2)
    lathe { cubic_spline 11
      <0, -3.5> <.2, -3.0> <.24, -2.6> <.12, -2.2> <.14, -1.0> <.26, 0>
      <.14, 1.0> <.12, 2.2> <.24, 2.6> <.2, 3.0> <0, 3.5>
      translate 1.5*x rotate (120*I + 75)*y
      texture { pigment { srgb <.38, .18, .08> } finish { Gloss } } }
  #end
  lathe { cubic_spline 9                                 // glass
    <1, -3.1> <1.0, -2.7> <1.18, -1.9> <.85, -.7> <.12, 0> <.85, .7> <1.18, 1.9> <1.0, 2.7> <1, 3.1>
    pigment { srgbt <.9, .97, 1, .88> } finish { ambient 0 diffuse .1 specular .9 roughness .008 reflection .10 } }
  union {                                                // sand
    lathe { cubic_spline 7 <0, -3.0> <0, -2.7> <.95, -2.7> <1.12, -2.0> <.55, -1.45> <0, -1.0> <0, -.5> }
    lathe { cubic_spline 7 <0, -.6> <0, -.3> <.14, .05> <.70, .65> <.90, .95> <0, .75> <0, .6> }
    pigment { srgb <.92, .72, .42> } finish { Satin } }
}

#declare Apple = union {
  lathe { cubic_spline 11
    <.2, .2> <.02, .45> <.25, .62> <.75, .72> <1.12, .35> <1.15, -.15>
    <.88, -.75> <.45, -1.02> <.15, -.92> <0, -.85> <0, -.5>
    pigment { bozo turbulence .5 scale <.5, 1.6, .5> color_map {
      [0 srgb <.72, .06, .05>] [.55 srgb <.80, .12, .06>] [1 srgb <.92, .55, .16>] } }
    finish { Gloss } }
  sphere_sweep { b_spline 5 <0, .2, 0>, .06  <0, .4, 0>, .06  <.05, .8, 0>, .05  <.2, 1.15, 0>, .07  <.4, 1.4, 0>, .08
    pigment { srgb <.25, .14, .06> } finish { Satin } }
}

#declare Scroll = union {                                // a rolled sheet with a ribbon and a seal
  cylinder { -2.7*x, 2.7*x, .55 open texture { pigment { srgb <.94, .87, .70> } finish { Satin } } }
  #for (S, -1, 1, 2)
    disc { 0, z, .55
      pigment { spiral1 1 scale .22 color_map {
        [.7 srgb <.94, .87, .70>] [.8 srgb <.45, .34, .2>] [1 srgb <.94, .87, .70>] } }
      finish { Satin } rotate 90*y translate 2.66*S*x }
  #end
  cylinder { -.22*x, .22*x, .58 pigment { srgb <.10, .22, .45> } finish { Gloss } }
  sphere { 0, 1 scale <.5, .5, .16> rotate 20*x translate <0, .12, -.58>
    pigment { srgb <.62, .05, .05> } finish { Gloss } }
}

// ---------------------------------------------------------------- arrangement
#declare Top = -6.6;                                     // of the table
object { Book(9.6, 1.7, 6.8, Leather(srgb <.12, .24, .20>)) rotate -14*y translate <-5.1, Top, -1.6> }
object { Book(8.4, 1.4, 6.0, Leather(srgb <.42, .07, .06>)) rotate 12*y translate <-3.6, Top + 1.7, -1.9> }
object { Skull
  translate <0, 2.04, 1.05> rotate 4*x translate -1.05*z scale 3.2    // resting on chin and jaw
  rotate 24*y translate <.2, Top + 3.08, 1.0> }
object { Candle scale 1.12 translate <Flame.x, Top, Flame.z> }
object { Hourglass translate <-5.4, Top + 3.3, 5.0> }
object { Scroll rotate 20*y translate <3.3, Top + .56, -2.7> }
object { Apple rotate <10, 0, -12> translate <-4.7, Top + 1.0, -2.9> }

union {                                                  // table
  box { <-40, Top - .7, -3.6>, <40, Top, 12> }
  cylinder { <-40, Top - .35, -3.6>, <40, Top - .35, -3.6>, .35 }
  box { <-40, Top - 9, -3.2>, <40, Top - .7, -2.8> }
  pigment { wood turbulence .06 rotate 88*y rotate 3*x scale 1.6 color_map {
    [0 srgb <.30, .16, .08>] [.6 srgb <.42, .24, .12>] [1 srgb <.24, .12, .06>] } }
  finish { Satin reflection { .02, .25 fresnel on } }
  interior { ior 1.4 }
}

height_field {                                           // velvet curtain
  function 400, 40 { .5 + .32*sin(38*x + 3*sin(2.2*y)) *(.6 + .4*sin(9*x + 1)) + .10*sin(83*x + 2*y) }
  smooth
  translate <-.5, 0, -.5> rotate -90*x scale <44, 34, 3.4> translate <0, 4, 10>
  pigment { aoi color_map { [.0 srgb <.55, .10, .13>] [.35 srgb <.30, .03, .06>] [1 srgb <.22, .02, .05>] } }
  finish { ambient 0 diffuse .8 emission .06 }
}
