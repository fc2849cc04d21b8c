// Constructive solid geometry: a gear wheel on its shaft, cut open to show the
// bearing. Everything is a sphere, box, cylinder, cone, torus or plane.
//   glim machine.pov +W800 +H500 +A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

camera {
  location <4.4, 4.9, -8.8>
  look_at <-0.1, -0.1, -0.5>
  right x * image_width / image_height
  angle 36
}
light_source { <-5, 10, -8> rgb <1.5, 1.4, 1.25> }
light_source { <10, 6, -2> rgb <0.4, 0.5, 0.7> }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.60, 0.64, 0.70>]
      [0.3 rgb <0.28, 0.32, 0.38>]
      [1.0 rgb <0.80, 0.84, 0.90>]
    }
  }
}

plane {
  y, -1.3
  pigment { rgb <0.05, 0.10, 0.16> }
  finish { ambient 0.15 diffuse 0.6 reflection { 0.02, 0.25 } }
}

#declare Steel = texture {
  pigment { rgb <0.50, 0.52, 0.55> }
  finish {
    ambient 0.08 diffuse 0.45
    specular 0.7 roughness 0.03 metallic
    reflection { 0.18 metallic }
  }
}
#declare Brass = texture {
  pigment { rgb <0.72, 0.47, 0.14> }
  finish {
    ambient 0.10 diffuse 0.5
    specular 0.8 roughness 0.04 metallic
    reflection { 0.20 metallic }
  }
}
#declare Paint = texture {
  pigment { rgb <0.55, 0.06, 0.03> }
  finish { ambient 0.12 diffuse 0.7 phong 0.6 phong_size 60 reflection 0.04 }
}

// One tooth: a wedge between two planes, rounded off by the outer cylinder.
#macro Tooth(Radius, Height, Width)
  intersection {
    box { <-Width, -Height, 0>, <Width, Height, Radius> }
    plane { x, Width * 0.62 rotate 7*y translate Radius * 0.9 * z }
    plane { -x, Width * 0.62 rotate -7*y translate Radius * 0.9 * z }
  }
#end

#declare Teeth = 28;
#declare Wheel = difference {
  union {
    cylinder { -0.42*y, 0.42*y, 2.22 }
    #for (I, 0, Teeth - 1)
      object { Tooth(2.62, 0.42, 0.24) rotate 360 / Teeth * I * y }
    #end
  }
  // Both faces are turned down between hub and rim.
  difference {
    cylinder { 0.18*y, 0.5*y, 1.92 }
    cylinder { 0.1*y, 0.6*y, 0.92 }
  }
  difference {
    cylinder { -0.18*y, -0.5*y, 1.92 }
    cylinder { -0.1*y, -0.6*y, 0.92 }
  }
  // Six holes lighten it.
  #for (I, 0, 5)
    cylinder { -y, y, 0.34 translate 1.42*x rotate (60 * I + 30) * y }
  #end
  // The edge of the rim is chamfered by a cone.
  difference {
    cylinder { 0.30*y, 0.5*y, 3 }
    cone { 0.30*y, 2.66, 0.5*y, 2.46 }
  }
}

#declare Ring = difference {
  cylinder { -0.3*y, 0.3*y, 0.86 }
  cylinder { -0.4*y, 0.4*y, 0.72 }
  torus { 0.62, 0.17 }
}
#declare Inner = difference {
  cylinder { -0.3*y, 0.3*y, 0.52 }
  cylinder { -0.4*y, 0.4*y, 0.38 }
  torus { 0.62, 0.17 }
}

// A quarter is cut out of wheel and rings; balls and shaft stay whole.
difference {
  object { Wheel }
  cylinder { -y, y, 0.86 }
  box { <0, -2, -4>, <4, 2, 0> texture { Paint } }
  texture { Steel }
}
difference {
  union { object { Ring } object { Inner } }
  box { <0, -2, -4>, <4, 2, 0> }
  texture { Brass }
}
#for (I, 0, 8)
  sphere { 0.62*x, 0.155 rotate 40 * I * y texture { Steel } }
#end

// The shaft: a step, a groove, a keyway and a threaded end.
difference {
  union {
    cylinder { -1.3*y, 1.5*y, 0.38 }
    cylinder { -1.3*y, -0.5*y, 0.7 }
    cone { 1.5*y, 0.38, 1.62*y, 0.26 }
  }
  box { <-0.08, 0.75, -0.5>, <0.08, 1.35, -0.27> }
  torus { 0.42, 0.09 translate 0.62*y }
  cylinder { 1.3*y, 2*y, 0.12 }
  texture { Steel }
}

// A hexagonal nut lies beside it: six planes, a hole, two cones.
#declare Nut = difference {
  intersection {
    #for (I, 0, 5) plane { x, 0.5 rotate 60 * I * y } #end
    plane { y, 0.24 }
    plane { -y, 0.24 }
    cone { -0.3*y, 0.5, 0.3*y, 0.68 }
    cone { 0.3*y, 0.5, -0.3*y, 0.68 }
  }
  cylinder { -y, y, 0.28 }
  #for (I, -5, 5) torus { 0.28, 0.025 translate 0.045 * I * y } #end
}
object { Nut texture { Brass } rotate 20*y translate <1.45, -1.06, -1.75> }
object {
  Nut texture { Steel }
  rotate <-68, 0, 0> rotate 35*y
  translate <-1.9, -0.85, -2.9>
}
