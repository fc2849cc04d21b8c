// A pillared hall at night, lit by nothing but its lamps: two rows of bowls
// along the nave and one small flame at every pillar, 54 lights in all: every
// point of every wall asks 54 times what reaches it.
//   glim hall.pov +W800 +H500 +A
//   glim hall.pov +W800 +H500 +A Declare=Bays=20     (more pillars and lamps)
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 0.4 }

#ifndef (Bays) #declare Bays = 9; #end

camera {
  location <0.9, 2.5, -4.6>
  look_at <-0.25, 2.65, 10>
  right x * image_width / image_height
  angle 62
}

#declare Stone = texture {
  pigment {
    granite
    color_map { [0 rgb <0.60, 0.54, 0.46>] [1 rgb <0.78, 0.73, 0.64>] }
    scale 0.8
  }
  finish { ambient 0.05 diffuse 0.75 }
}
#declare Gold = texture {
  pigment { rgb <0.80, 0.52, 0.16> }
  finish {
    ambient 0.15 diffuse 0.5 reflection { 0.3 metallic }
    specular 0.8 roughness 0.03 metallic
  }
}

// The floor: slabs of two kinds, polished.
plane {
  y, 0
  pigment {
    checker
    rgb <0.30, 0.10, 0.07>
    rgb <0.72, 0.66, 0.54>
    scale 0.9
    rotate 45*y
  }
  finish { ambient 0.05 diffuse 0.7 reflection { 0.05, 0.45 } }
}

#declare Pillar = union {
  box { <-0.48, 0, -0.48>, <0.48, 0.25, 0.48> }
  torus { 0.36, 0.09 translate 0.32*y }
  difference {
    cone { 0.3*y, 0.36, 3.9*y, 0.30 }
    #for (I, 0, 11)
      cylinder { 0.45*y, 3.75*y, 0.055 translate 0.36*x rotate 30 * I * y }
    #end
  }
  torus { 0.33, 0.06 translate 3.85*y }
  cone { 3.9*y, 0.32, 4.2*y, 0.50 }
  box { <-0.52, 4.2, -0.52>, <0.52, 4.4, 0.52> }
}

// Two walls of arches carry the vault.
#declare Length = 3 * Bays;
union {
  #for (I, 0, Bays)
    object { Pillar translate <-2.4, 0, 3 * I> }
    object { Pillar translate <2.4, 0, 3 * I> }
  #end
  texture { Stone }
}
difference {
  union {
    box { <-2.9, 4.4, -9>, <-1.9, 6.4, Length + 1> }
    box { <1.9, 4.4, -9>, <2.9, 6.4, Length + 1> }
  }
  #for (I, -3, Bays - 1)
    cylinder { <-4, 4.4, 3 * I + 1.5>, <4, 4.4, 3 * I + 1.5>, 1.05 }
  #end
  texture { Stone }
}
difference {
  box { <-7, 6.2, -9>, <7, 9.5, Length + 1> }
  cylinder { <0, 6.2, -10>, <0, 6.2, Length + 2>, 2.3 }
  texture { Stone }
}
// Outer walls and the far end with a round window.
union {
  plane { x, -5.2 }
  plane { -x, -5.2 }
  texture { Stone }
}
difference {
  box { <-6, 0, Length + 1>, <6, 10, Length + 1.6> }
  cylinder { <0, 5.6, Length>, <0, 5.6, Length + 3>, 1.5 }
  texture { Stone }
}
background { rgb <0.02, 0.04, 0.12> }

// A hanging bowl. Its light fades with distance; the glowing ball inside is
// only its look (looks_like casts no shadow of its own).
#macro Bowl(Where)
  light_source {
    Where
    rgb <0.80, 0.55, 0.28>
    fade_distance 1.6 fade_power 2
    looks_like {
      sphere { 0, 0.13 pigment { rgb 1 } finish { ambient 0 emission <2, 1.5, 0.9> } }
    }
  }
  difference {
    sphere { 0, 0.3 }
    sphere { 0, 0.27 }
    plane { -y, 0.02 }
    texture { Gold }
    translate Where
  }
  cylinder { Where + 0.25*y, Where + 4.5*y, 0.015 texture { Gold } }
#end
#macro Flame(Where)
  light_source { Where rgb <0.55, 0.25, 0.09> fade_distance 0.9 fade_power 2 }
  sphere {
    0, 0.05
    scale <1, 2.2, 1>
    pigment { rgb 1 }
    finish { ambient 0 emission <2.2, 1.1, 0.35> }
    no_shadow
    translate Where
  }
  cone { Where - 0.35*y, 0.02, Where - 0.13*y, 0.08 texture { Gold } no_shadow }
#end

#for (I, 0, Bays - 1)
  Bowl(<-1.1, 4.1, 3 * I + 1.5>)
  Bowl(<1.1, 4.1, 3 * I + 1.5>)
  Flame(<-1.93, 2.2, 3 * I>)
  Flame(<1.93, 2.2, 3 * I>)
  Flame(<-4.9, 2.6, 3 * I + 1.5>)
  Flame(<4.9, 2.6, 3 * I + 1.5>)
#end
