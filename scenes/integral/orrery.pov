// SPDX-License-Identifier: AGPL-3.0-or-later
//
// orrery.pov -- an animation as a moving integral picture: one turn of the clock is a loop without a seam
//
// A brass planetarium in front of a star chart. The planets go round on their arms: in front they come out of the
// paper, at the back they pass behind it, and Saturn's ring crosses it twice in a turn.
//
//   povray-integral +Iorrery.pov +W4800 +H1600 +A0.1 +AM2 +R4 +Oorrery.png      (or: povray-integral orrery.ini)
//   povray-integral +Iorrery.pov +W4800 +H1600 Integral_Draft=2 +KFF48 +KC +Oturn.png
//   integral replay turn??.png --path sway,120 -o turn.webp
//
// Frame      4800 x 1600 pixels at 600 x 300 dpi = 203.2 x 135.5 mm, 320 lenses
// Sheet      lenticular, pitch 0.635 mm (40 lenses per inch, 15 pixels), thickness 2.1 mm, index 1.49, seen from 450 mm
// Scale      1 unit = 10 mm; the sheet is upright but for 13 degrees, through the sun
// Depth      rim of the dial -74 mm, Saturn -58 to +58 mm, Jupiter -46 to +46 mm | star chart +70 to +100 mm
// Time       about 2.5 microseconds of a processor a pixel; with the anti-aliasing above 19
//
#version 3.7;
global_settings { assumed_gamma 1.0  max_trace_level 6 }

#declare Eye    = <0, 10, -44>;
#declare Sheet  = <0, -1.1, 0>;
#declare Window = 20.32;                                 // width at the sheet, units

camera {
  integral
  lens_sheet { lenticular pitch 25.4/40 thickness 2.1 ior 1.49 }
  film { dpi <600, 300> }
  location Eye  look_at Sheet
  right x*3/2  up y
  angle 2*degrees(atan2(Window/2, vlength(Sheet - Eye)))
}

// ---------------------------------------------------------------- light
light_source { <-40, 46, -60>*3 srgb <1, .93, .80>*1.15 }
light_source { <60, 20, -50>*3 srgb <.60, .72, 1>*.35 shadowless }
light_source { <0, 60, 60>*3 srgb <.55, .62, 1>*.45 shadowless }
light_source { <0, 0, 0> srgb <1, .70, .34>*1.7 fade_distance 3.2 fade_power 2 shadowless }        // the sun

// ---------------------------------------------------------------- paints
#declare Brass = texture {
  pigment { srgb <.83, .58, .24> }
  finish {
    ambient 0 diffuse .42 brilliance 1.6 specular .8 roughness .02 metallic
    reflection { .34 metallic } conserve_energy
  }
}
#declare Gold = texture {
  pigment { srgb <.98, .76, .34> }
  finish { ambient 0 diffuse .55 specular .9 roughness .03 metallic reflection { .25 metallic } conserve_energy }
}
#declare Enamel = finish {
  ambient 0 diffuse .8 specular .55 roughness .015 reflection { .02, .25 fresnel on } conserve_energy
}
#declare Walnut = texture {
  pigment {
    wood turbulence .07 scale <.5, .5, 3> rotate <4, 84, 0> translate <3, 1, 0>
    color_map { [0 srgb <.22, .105, .05>] [.55 srgb <.33, .165, .075>] [1 srgb <.16, .075, .04>] }
  }
  finish { ambient 0 diffuse .75 specular .35 roughness .02 reflection { .01, .22 fresnel on } conserve_energy }
}

// ---------------------------------------------------------------- the star chart behind
#declare Night = srgb <.022, .045, .13>;
box {
  <-40, -40, 8.3>, <40, 40, 8.4>
  pigment {
    spherical scale 34 translate <0, -3, 8.3>
    color_map { [0 rgb Night*.2] [.55 rgb Night*.7] [.8 rgb Night*1.4] [1 rgb <.065, .125, .32>] }
  }
  finish { ambient 0 emission .8 diffuse .25 }
  rotate -12*x
}
#macro Star(P, Size)                                     // a star of eight points in gold leaf
  union {
    #for (K, 0, 3)
      prism { linear_spline -.02, .02, 5, <0, Size>, <Size*.2, 0>, <0, -Size>, <-Size*.2, 0>, <0, Size>
        rotate -90*x rotate K*45*z
        #if (mod(K, 2)) scale <.62, .62, 1> #end }
    #end
    translate <P.x, P.y, 8.2>
    texture { Gold } finish { emission .45 }
  }
#end
#macro Line(P, Q)
  cylinder { <P.x, P.y, 8.22>, <Q.x, Q.y, 8.22>, .045 texture { Gold } finish { emission .12 } }
#end
union {
  #declare Bear = array[7] { <-11, 0.3>, <-9.3, 1.6>, <-7.7, 1.2>, <-6, 0.7>, <-5.7, -1>, <-3.2, -0.6>, <-2.9, 1.5> }
  #for (K, 0, 6) Star(Bear[K], .52) #if (K < 6) Line(Bear[K], Bear[K+1]) #end #end
  Line(Bear[6], Bear[3])
  #declare Queen = array[5] { <3.8, 1.6>, <5.6, -0.1>, <7.4, 1.1>, <9.0, -0.8>, <10.8, 0.5> }
  #for (K, 0, 4) Star(Queen[K], .56) #if (K < 4) Line(Queen[K], Queen[K+1]) #end #end
  Star(<.4, 2.5>, .8)
  #declare Dice = seed(12);
  #for (K, 1, 80)
    #declare P = <(rand(Dice) - .5)*29, rand(Dice)*15 - 10>;
    sphere { <P.x, P.y, 8.25>, .05 + .09*pow(rand(Dice), 3) texture { Gold } finish { emission .5 } }
  #end
  rotate -12*x
}

// ---------------------------------------------------------------- the base and its dial
#macro Hoop(R, Y, Thick) torus { R, Thick translate Y*y } #end
union {
  cylinder { -4.6*y, -4.05*y, 7.5 texture { Walnut } }
  torus { 7.5, .275 translate -4.325*y texture { Walnut } }
  object { Hoop(7.42, -4.02, .12) texture { Brass } }
  object { Hoop(5.5, -4.02, .10) texture { Brass } }
  cylinder { -4.1*y, -4.0*y, 7.4                         // the zodiac: enamel in twelve parts
    texture {
      pigment { radial frequency 12
        color_map { [.5 srgb <.93, .87, .72>] [.5 srgb <.05, .13, .25>] } }
      finish { Enamel }
    } }
  cylinder { -4.1*y, -3.98*y, 5.5 texture { Walnut } }
  cylinder { -4.1*y, -3.94*y, 3.1 texture { pigment { srgb <.05, .13, .25> } finish { Enamel } } }
  object { Hoop(3.1, -3.95, .08) texture { Brass } }
  #for (K, 0, 71)
    #declare Long = (mod(K, 6) = 0 ? .75 : .38);
    box { <7.25 - Long, -4, -.035>, <7.25, -3.96, .035> rotate K*5*y texture { Gold } }
  #end
  #for (K, 0, 11)
    sphere { <6.1, -3.96, 0>, .2 scale <1, .5, 1> rotate (K*30 + 15)*y texture { Gold } }
  #end
}

// ---------------------------------------------------------------- the train of wheels
#macro Wheel(R, Teeth, Y, Thick, Turns)
  union {
    difference {
      union {
        cylinder { 0, Thick*y, R }
        #for (K, 0, Teeth - 1)
          box { <R - .05, 0, -pi*R/Teeth*.52>, <R + .16, Thick, pi*R/Teeth*.52> rotate K*360/Teeth*y }
        #end
      }
      cylinder { -.1*y, (Thick + .1)*y, R*.82 }
    }
    #for (K, 0, 4) box { <0, Thick*.2, -R*.055>, <R*.85, Thick*.8, R*.055> rotate K*72*y } #end
    cylinder { 0, (Thick + .08)*y, R*.2 }
    rotate -360*clock*Turns*y
    translate Y*y
    texture { Brass }
  }
#end
object { Wheel(2.5, 48, -3.85, .22, 1) }
object { Wheel(1.9, 36, -3.45, .2, 2) }
object { Wheel(1.35, 28, -3.1, .2, 3) }
object { Wheel(.95, 20, -2.78, .18, 4) }

union {                                                  // the column
  cone { -3.9*y, .62, -3.5*y, .3 }
  cylinder { -3.9*y, -1.1*y, .2 }
  sphere { -1.35*y, .36 scale <1, .6, 1> translate -.54*y }
  cylinder { -1.1*y, -.6*y, .12 }
  texture { Brass }
}

// ---------------------------------------------------------------- the sun
sphere {
  0, 1.02
  pigment {
    bumps scale .22 warp { turbulence .4 }
    color_map { [0 srgb <1, .50, .08>] [.5 srgb <1, .70, .18>] [1 srgb <1, .90, .46>] }
  }
  finish { ambient 0 emission .95 diffuse .2 specular .3 roughness .05 }
}
#for (K, 0, 15)                                          // its rays
  cone { 1.12*x, .12, (mod(K, 2) ? 1.5 : 1.78)*x, .015 rotate K*22.5*z rotate -8*x texture { Gold } finish { emission .3 } }
#end
torus { 1.13, .07 rotate 90*x rotate -8*x texture { Gold } }

// ---------------------------------------------------------------- planets
// An arm at height Y carries what stands at <R, 0, 0>; it goes round Turns times in the clock's turn.
#macro Arm(R, Y, Turns, Start, Stem)
  union {
    cylinder { <0, Y, 0>, <R, Y, 0>, .075 }
    cylinder { <-R*.28 - .5, Y, 0>, <0, Y, 0>, .075 }
    sphere { <-R*.28 - .5, Y, 0>, .2 }
    cylinder { <0, Y - .13, 0>, <0, Y + .13, 0>, .34 }
    sphere { <R, Y, 0>, .13 }
    cylinder { <R, Y, 0>, <R, -Stem, 0>, .055 }
    rotate -(360*clock*Turns + Start)*y
    texture { Brass }
  }
#end
#macro Planet(Thing, R, Turns, Start)
  object { Thing translate R*x rotate -(360*clock*Turns + Start)*y }
#end

Arm(2.1, -1.25, 4, 30, .2)
Planet(sphere { 0, .27 pigment { granite scale .3 color_map { [0 srgb <.55, .47, .40>] [1 srgb <.80, .72, .62>] } } finish { Enamel } }, 2.1, 4, 30)

Arm(2.95, -1.65, 3, 140, .3)
Planet(sphere { 0, .43 pigment { gradient y turbulence .5 scale .35 color_map { [0 srgb <.93, .78, .48>] [1 srgb <.98, .92, .75>] } } finish { Enamel } }, 2.95, 3, 140)

#declare Earth = union {
  sphere { 0, .52
    pigment {
      bozo scale .3 translate 7 warp { turbulence .35 }
      color_map {
        [.50 srgb <.05, .22, .52>] [.54 srgb <.10, .38, .62>] [.54 srgb <.20, .42, .14>] [.80 srgb <.52, .46, .20>]
      }
    }
    finish { Enamel } }
  sphere { 0, .535
    pigment { bozo scale <.3, .14, .3> translate 3 warp { turbulence .7 }
      color_map { [.55 rgbt <1, 1, 1, 1>] [.75 rgbt <1, 1, 1, .15>] } }
    finish { ambient 0 diffuse .9 } }
  union {
    cylinder { <0, -.34, 0>, <.98, -.34, 0>, .045 texture { Brass } }
    cylinder { <.98, -.34, 0>, <.98, 0, 0>, .035 texture { Brass } }
    sphere { .98*x, .17 pigment { granite scale .2 color_map { [0 srgb .5] [1 srgb .85] } } finish { Enamel } }
    rotate -360*8*clock*y
  }
}
Arm(3.85, -2.05, 2, 250, .3)
Planet(Earth, 3.85, 2, 250)

Arm(4.55, -2.45, 2, 75, .3)
Planet(sphere { 0, .36 pigment { bozo scale .2 turbulence .4 color_map { [0 srgb <.66, .24, .10>] [1 srgb <.86, .44, .22>] } } finish { Enamel } }, 4.55, 2, 75)

#declare Jupiter = sphere {
  0, .95
  pigment {
    gradient y turbulence .06 scale 2 translate -1*y
    color_map {
      [0 srgb <.62, .47, .36>] [.18 srgb <.86, .76, .62>] [.27 srgb <.67, .41, .26>] [.33 srgb <.92, .84, .70>]
      [.45 srgb <.95, .90, .80>] [.50 srgb <.70, .40, .24>] [.58 srgb <.74, .46, .28>] [.63 srgb <.94, .86, .72>]
      [.76 srgb <.78, .58, .42>] [.84 srgb <.90, .80, .66>] [1 srgb <.60, .46, .38>]
    }
  }
  finish { Enamel }
  scale <1, .95, 1>
  rotate 4*z
}
Arm(5.3, -2.85, 1, 205, .7)
Planet(Jupiter, 5.3, 1, 205)

#declare Saturn = union {
  sphere { 0, .72
    pigment { gradient y turbulence .04 scale 1.6 translate -.8*y
      color_map { [0 srgb <.70, .56, .36>] [.3 srgb <.93, .82, .58>] [.5 srgb <.85, .68, .42>] [.7 srgb <.95, .86, .64>] [1 srgb <.72, .58, .40>] } }
    finish { Enamel } }
  difference {
    cylinder { -.02*y, .02*y, 1.62 }
    cylinder { -.1*y, .1*y, .95 }
    pigment {
      cylindrical scale 1.62
      color_map {
        [0 srgb <.80, .66, .44>] [.14 srgb <.93, .83, .62>] [.17 srgb <.32, .25, .18>] [.21 srgb <.32, .25, .18>]
        [.23 srgb <.90, .78, .55>] [.36 srgb <.72, .58, .38>] [.41 srgb <.50, .40, .28>]
      }
    }
    finish { Enamel }
  }
  rotate <-12, 0, 22>
}
Arm(6.3, -3.2, 1, 318, .6)
Planet(Saturn, 6.3, 1, 318)
