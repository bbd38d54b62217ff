// SPDX-License-Identifier: AGPL-3.0-or-later
//
// horse.pov -- a full parallax picture under square lenses
//
// A carousel: the jumper's head and raised legs come out of the paper, its quarters lie behind, two more horses and
// the drum stand farther back, and the platform's edge runs along the front. Look over and under, left and right.
//
//   povray-integral +Ihorse.pov +W2400 +H1800 +Ohorse.png            (or: povray-integral horse.ini)
//   integral replay horse.png --eye 80,60,450 -o view.png
//
// Frame      2400 x 1800 pixels at 300 dpi = 203.2 x 152.4 mm, 181 x 136 lenses
// Sheet      square, pitch 1.124 mm (13.28 pixels), thickness 3.23 mm, index 1.675, seen from 450 mm
// Scale      1 unit = 10 mm; the sheet is upright but for 2.5 degrees, near the plane z = 0
// Depth      nose -31 mm, platform's edge -30 mm | tail +47 mm, other horses +20 to +55 mm, drum +60 mm
// Time       about 10 microseconds a pixel
//
#version 3.7;
global_settings { assumed_gamma 1.0  max_trace_level 6 }

#declare Eye    = <0, 2.0, -45>;
#declare Sheet  = <0, 0, 0>;
#declare Window = 20.32;                                 // width at the sheet, units

camera {
  integral
  lens_sheet { square pitch 1.124 thickness 3.23 ior 1.675 }
  film { dpi 300 }
  location Eye  look_at Sheet
  right x*image_width/image_height  up y
  angle 2*degrees(atan2(Window/2, vlength(Sheet - Eye)))
}

light_source { <-34, 21, -60>*4 srgb <1, .94, .84>*1.1 }
light_source { <60, 14, -40>*4 srgb <.75, .80, 1>*.4 shadowless }
light_source { <4, 7.4, 4> srgb <1, .80, .52>*1.3 shadowless fade_distance 8 fade_power 2 }

#declare Enamel = finish {
  ambient 0 diffuse .8 specular .5 roughness .02 reflection { .02, .25 fresnel on } conserve_energy
}
#declare Satin = finish { ambient 0 diffuse .8 specular .2 roughness .05 }
#declare Gilt = texture {
  pigment { srgb <.95, .72, .28> }
  finish { ambient 0 diffuse .55 specular .8 roughness .025 metallic reflection { .18 metallic } }
}
#declare Coat = texture {
  pigment { srgb <.96, .93, .88> }
  finish { Enamel }
}

// ---------------------------------------------------------------- the horse: head +x, up y, 1 unit = 10 mm
// Blob chains: with a threshold of .25 a chain from A to B is about as thick as asked for.
#macro Ball(P, R) sphere { P, 1.414*R, 1 } #end
#macro Chain(A, Ra, B, Rb, Flat)
  #local L = vlength(B - A);
  #local T = 0;
  #while (T <= 1)
    #local R = Ra + (Rb - Ra)*T;
    sphere { 0, 1.414*R, .33 scale <1, 1, Flat> translate A + (B - A)*T }
    #local T = T + .35*R/L;
  #end
#end

#declare Hooves = array[4][4] {                              // joints of each leg, hoof last
  { <2.45, -1.25, -.75>, <3.85, -1.65, -.85>, <3.35, -3.45, -.8>, <2.90, -3.85, -.8> }
  { <2.50, -1.15, .75>, <4.15, -.95, .85>, <4.40, -2.75, .85>, <4.00, -3.2, .85> }
  { <-2.0, -1.30, -.85>, <-3.75, -2.55, -.9>, <-3.30, -4.35, -.9>, <-2.90, -4.75, -.9> }
  { <-2.3, -1.25, .85>, <-4.25, -2.2, .9>, <-4.65, -4.0, .9>, <-4.40, -4.5, .9> }
}
#macro Trunk()
  Chain(<1.8, .0, 0>, 1.52, <-.2, -.12, 0>, 1.48, .84)
  Chain(<-.2, -.10, 0>, 1.42, <-2.0, .28, 0>, 1.22, .88)
  Ball(<2.55, -.2, 0>, 1.1)  Ball(<1.25, 1.05, 0>, .62)  Ball(<-1.9, .62, 0>, .85)
  #for (S, -1, 1, 2)
    Ball(<2.95, -.2, .42*S>, .72)
    Ball(<2.05, .15, .66*S>, .95)
    Ball(<2.35, -.65, .62*S>, .62)
    Ball(<-2.6, .42, .50*S>, 1.18)
    Ball(<-3.2, .05, .55*S>, .92)
    Chain(<-2.7, .1, S*.75>, 1.05, Hooves[2.5 + S/2][0], .80, .82)
  #end
#end
#macro Neck()
  Chain(<2.1, .8, 0>, 1.22, <2.95, 2.15, 0>, 1.02, .68)
  Chain(<2.95, 2.15, 0>, 1.00, <3.45, 3.4, 0>, .80, .66)
  Chain(<3.45, 3.4, 0>, .78, <4.05, 4.45, 0>, .60, .74)
#end
#macro Head()
  Chain(<4.25, 4.5, 0>, .58, <4.85, 4.0, 0>, .56, .82)
  Chain(<4.85, 4.0, 0>, .54, <5.5, 3.15, 0>, .42, .80)
  Chain(<5.5, 3.15, 0>, .40, <6.0, 2.5, 0>, .37, .92)
  Chain(<4.9, 3.3, 0>, .26, <5.62, 2.3, 0>, .22, 1.1)
  Ball(<5.66, 2.24, 0>, .22)
  #for (S, -1, 1, 2)
    Ball(<4.62, 3.72, .22*S>, .56)
    Ball(<4.82, 4.32, .30*S>, .26)
    Ball(<6.08, 2.55, .18*S>, .2)
  #end
#end
#macro Fore_Leg(S, Elbow, Knee, Fetlock, Toe)
  Ball(Elbow + <-.1, .5, 0>, .75)
  Chain(Elbow, .60, Knee, .32, 1)  Ball(Knee, .33)
  Chain(Knee, .28, Fetlock, .20, 1)  Ball(Fetlock, .25)
  Chain(Fetlock, .2, Toe, .23, 1)
#end
#macro Hind_Leg(S, Stifle, Hock, Fetlock, Toe)
  Chain(Stifle, .74, Hock, .30, .9)  Ball(Hock + <-.06, .06, 0>, .32)
  Chain(Hock, .29, Fetlock, .21, 1)  Ball(Fetlock, .26)
  Chain(Fetlock, .21, Toe, .24, 1)
#end
#macro Legs()
  #for (I, 0, 1)
    Fore_Leg(2*I - 1, Hooves[I][0], Hooves[I][1], Hooves[I][2], Hooves[I][3])
    Hind_Leg(2*I - 1, Hooves[I+2][0], Hooves[I+2][1], Hooves[I+2][2], Hooves[I+2][3])
  #end
#end

// Skin(P): a smooth mesh through the grid P[row][column], closed around the columns.
#macro Skin(P)
  #local N = dimension_size(P, 1);
  #local M = dimension_size(P, 2);
  mesh2 {
    vertex_vectors { N*M
      #for (I, 0, N-1) #for (J, 0, M-1) , P[I][J] #end #end }
    normal_vectors { N*M
      #for (I, 0, N-1) #for (J, 0, M-1)
        #local C = vcross(P[min(I+1, N-1)][J] - P[max(I-1, 0)][J], P[I][mod(J+1, M)] - P[I][mod(J+M-1, M)]);
        , #if (vlength(C) > 1e-9) vnormalize(C) #else y #end
      #end #end }
    face_indices { 2*(N-1)*M
      #for (I, 0, N-2) #for (J, 0, M-1)
        #local A = I*M + J;
        #local B = I*M + mod(J+1, M);
        , <A, B, A+M>, <B, B+M, A+M>
      #end #end }
  }
#end

// A lock of hair along four points: grooved, tapered, flat towards Side.
#macro Lock(A, B, C, D, R, Side)
  #local Path = spline { natural_spline 0, A, .33, B, .66, C, 1, D }
  #local N = 18; #local M = 20;
  #local P = array[N+1][M];
  #for (I, 0, N)
    #local T = I/N;
    #local U = vnormalize(Path(T + .01) - Path(T - .01));
    #local V = vnormalize(vcross(U, Side));
    #local W = vcross(V, U);
    #for (J, 0, M-1)
      #local Q = 2*pi*J/M;
      #local K = R*(.015 + pow(sin(pi*pow(.12 + .88*T, .7)), .7))*(1 + .16*cos(5*Q + 2*T));
      #local P[I][J] = Path(T) + K*(cos(Q)*V + .5*sin(Q)*W);
    #end
  #end
  Skin(P)
#end

#declare Mane = union {
  #declare Roots = spline { natural_spline
    0, <4.35, 5.0, 0>, .3, <3.45, 4.55, 0>, .65, <2.45, 3.1, 0>, 1, <1.45, 1.75, 0> }
  #for (I, 0, 10)
    #local T = I/10;
    #local A = Roots(T);
    #local Z = -(.50 + .12*T);
    Lock(A + <.05, -.1, 0>, A + <-.15, -.05, Z>, A + <-.25, -.75, 1.25*Z>,
      A + <-.85, -1.15 - .3*mod(I, 2), 1.3*Z>, .32, z)
    Lock(A + <.05, -.1, 0>, A + <-.2, 0, -Z>, A + <-.4, -.6, -1.25*Z>, A + <-.95, -1.0, -1.3*Z>, .30, z)
  #end
  Lock(<4.1, 5.0, 0>, <4.7, 5.0, -.1>, <5.05, 4.5, -.12>, <5.2, 3.9, -.1>, .24, z)
}
#declare Tail = union {
  #for (I, -3, 3)
    Lock(<-3.6, .75, .05*I>, <-4.7 - .1*abs(I), 1.2 - .08*I, .14*I>, <-5.7, -.6 + .12*I, .22*I>,
      <-6.0 - .25*mod(I + 4, 3), -3.0 + .35*abs(I), .30*I>, .34, z)
  #end
}

// Tack follows the body: a slightly fatter copy of its blob, cut to the shape of the strap or cloth.
#macro Band(A, Along, Half)
  box { <-1e2, -Half, -9>, <1e2, Half, 9> rotate degrees(atan2(Along.y, Along.x))*z translate A }
#end
#macro Over_Trunk(T) blob { threshold T Trunk() Neck() } #end
#macro Over_Head(T) blob { threshold T Neck() Head() } #end
#macro Oval(A, Rx, Ry) cylinder { -9*z, 9*z, 1 scale <Rx, Ry, 1> translate A } #end

#macro Tack(Cloth, Trim)
  union {
    intersection { Over_Trunk(.215) Oval(<-.1, .55, 0>, 1.95, 1.75) texture { Gilt } }
    intersection { Over_Trunk(.200) Oval(<-.1, .60, 0>, 1.72, 1.55) texture { Cloth } }
    intersection { Over_Trunk(.185) Oval(<.05, .95, 0>, 1.30, 1.15) texture { Trim } }
    intersection { Over_Trunk(.205) Band(<.1, 0, 0>, y, .2) texture { Trim } }
    intersection { Over_Trunk(.205) Band(<3.0, .0, 0>, <1.9, -1.15, 0>, .21) box { <1, -9, -9>, 9 } texture { Trim } }
    intersection { Over_Trunk(.205) Band(<-3.0, .1, 0>, <2, .55, 0>, .19) box { -9, <-1.4, 9, 9> } texture { Trim } }
    #for (S, -1, 1, 2)
      #for (I, 0, 2)
        sphere { 0, 1 scale <.2, .2, .12> translate <2.2 + .45*I, .55 - .28*I, S*(1.42 - .16*I)> texture { Gilt } }
      #end
      sphere { 0, 1 scale <.22, .22, .12> translate <-2.9, .12, S*1.66> texture { Gilt } }
      sphere_sweep { b_spline 6                              // rein
        <5.6, 3.2, .5*S>, .085  <5.45, 2.95, .46*S>, .085  <4.2, 2.3, .9*S>, .085
        <3.0, 2.1, .95*S>, .085  <1.6, 1.9, .4*S>, .085  <1.2, 1.9, .2*S>, .085
        texture { Trim } }
      sphere { <4.93, 4.32, .46*S>, .14 texture { pigment { srgb <.06, .04, .03> } finish { Enamel } } }
      sphere { <6.22, 2.62, .27*S>, .085 texture { pigment { srgb <.35, .12, .12> } finish { Satin } } }
      torus { .17, .05 rotate 90*x translate <5.42, 2.92, .43*S> texture { Gilt } }
    #end
    blob { threshold .25                                     // seat, cantle, pommel
      sphere { 0, 1.414, 1 scale <1.15, .30, .62> translate <-.05, 1.52, 0> }
      sphere { 0, 1.414, 1 scale <.22, .55, .72> rotate 18*z translate <-1.12, 1.72, 0> }
      sphere { 0, 1.414, 1 scale <.18, .42, .36> rotate -16*z translate <1.02, 1.85, 0> }
      texture { Trim } }
    intersection { Over_Head(.20) Band(<5.50, 3.12, 0>, <.78, .62, 0>, .15) box { <4.9, -9, -9>, 9 } texture { Trim } }
    intersection { Over_Head(.20)
      Band(<4.52, 4.28, 0>, <.62, .78, 0>, .15) Band(<4.6, 4.37, 0>, <.78, -.62, 0>, .95) texture { Trim } }
    intersection { Over_Head(.20)
      Band(<5.05, 3.62, 0>, <.62, -.78, 0>, .13) Band(<5.0, 3.7, 0>, <.72, .69, 0>, .72) texture { Trim } }
  }
#end

#macro Horse(Coat, Hair, Cloth, Trim)
  union {
    blob { threshold .25 Trunk() Neck() Head() Legs() texture { Coat } }
    #for (I, 0, 3)
      #local D = vnormalize(Hooves[I][3] - Hooves[I][2]);
      cone { Hooves[I][3] - .06*D, .25, Hooves[I][3] + .42*D, .36 texture { Gilt } }
    #end
    #for (S, -1, 1, 2)
      difference {                                           // ears
        sphere { 0, 1 scale <.20, .50, .18> }
        sphere { 0, 1 scale <.20, .44, .11> translate <.16, -.02, 0>
          texture { pigment { srgb <.75, .50, .46> } finish { Satin } } }
        rotate <8*S, -35*S, -14> translate <4.22, 5.18, .30*S> texture { Coat }
      }
    #end
    union { object { Mane } object { Tail } texture { Hair } }
    Tack(Cloth, Trim)
  }
#end
#macro Paint(C) texture { pigment { C } finish { Enamel } } #end


// ---------------------------------------------------------------- the carousel
#declare Ivory = srgb <.96, .93, .88>;
#declare Red   = srgb <.66, .05, .07>;
#declare Teal  = srgb <.05, .34, .40>;

#declare Barley =                                        // a twisted pole, 1 turn in 2 units
  #local P = array[201][28];
  #for (I, 0, 200)
    #for (J, 0, 27)
      #local Q = 2*pi*J/28;
      #local K = .21*(1 + .20*cos(3*Q));
      #local P[I][J] = <K*cos(Q + pi*I/10), .1*I, K*sin(Q + pi*I/10)>;
    #end
  #end
  Skin(P)
#declare Pole = union {
  object { Barley translate -6*y }
  sphere { 0, .42 scale <1, .6, 1> translate 1.9*y }
  cone { <0, -2.4, 0>, .2, <0, -1.6, 0>, .4 }
  texture { Gilt }
}
#macro Rider(Coat, Hair, Cloth, Trim)
  union {
    object { Horse(Coat, Hair, Cloth, Trim) translate -.35*x }
    object { Pole translate .2*x }
    rotate 40*y
  }
#end

object { Rider(Paint(Ivory), Gilt, Paint(Teal), Paint(Red)) translate <-.3, .1, .6> }
object { Rider(Paint(srgb <.36, .17, .08>), Paint(srgb <.96, .90, .78>), Paint(Red), Paint(srgb <.90, .72, .3>))
  scale <.82, .82, .46> translate <-9.0, .8, 3.4> }
object { Rider(Paint(srgb <.20, .20, .23>), Paint(srgb <.93, .92, .95>), 
    Paint(srgb <.30, .12, .40>), Paint(srgb <.85, .82, .75>))
  scale <.82, .82, .46> translate <9.3, -.6, 3.9> }

// Platform: planks that run round the carousel's hub; its front edge stands before the sheet.
#declare Hub = <0, 0, 26>;
union {
  cylinder { <0, -6.2, 0>, <0, -5.6, 0>, 29
    pigment { radial frequency 80 color_map {
      [0 srgb <.30, .16, .08>] [.06 srgb <.62, .38, .21>] [.9 srgb <.70, .45, .26>] [1 srgb <.3, .16, .08>] } }
    finish { Satin reflection .06 } }
  torus { 29, .24 translate -5.75*y texture { Gilt } }
  cylinder { <0, -12, 0>, <0, -6, 0>, 28.8 open Paint(Red) }
  #for (I, -8, 8) sphere { <0, -6.9, -28.8>, .36 rotate 3.2*I*y texture { Gilt } } #end
  translate Hub
}

// The drum in the middle, flattened so that its front is 60 mm behind the sheet: framed ovals between gilt columns,
// bulbs above.
union {
  cylinder { -6*y, 9*y, 15.6 open
    pigment { srgb <.05, .38, .44> } finish { ambient 0 diffuse .32 emission .42 } }
  torus { 15.7, .5 translate -5.6*y texture { Gilt } }
  #for (I, -4, 4)
    union {
      cylinder { <0, -6, -15.7>, <0, 9, -15.7>, .38 texture { Gilt } }
      union {
        disc { 0, z, 1
          pigment { gradient y scale 2.01 translate -1*y color_map {
            [0 srgb <.90, .60, .48>] [.5 srgb <.98, .88, .72>] [1 srgb <.55, .72, .80>] } }
          finish { ambient 0 diffuse .3 emission .5 } }
        torus { 1, .10 rotate 90*x texture { Gilt } }
        scale <1.9, 3.1, 1> translate <0, .6, -15.7> rotate 11*y
      }
      #for (K, 0, 2)
        sphere { <0, 6.0, -16.1>, .38 rotate (K*22/3 - 7.33)*y
          pigment { rgb 1 } finish { ambient 0 diffuse 0 emission srgb <1, .86, .58>*1.4 } no_shadow }
      #end
      rotate 22*I*y
    }
  #end
  disc { 8.6*y, y, 29
    pigment { radial frequency 32 color_map { [.5 Red] [.5 Ivory] } } finish { Satin emission .15 } no_shadow }
  scale <.94, .98, .55>  translate <0, -.1, 14.7>
}
sky_sphere { pigment { function { max(0, y) } color_map { [0 srgb <.55, .38, .42>] [.5 srgb <.12, .16, .36>] } } }
