// The floor beside a ball that lies on it, in the ball's shade.
// claims: path bounced
// options path: --samples 4096
//
// The lamp, straight above, leaves nothing of itself there; what is lit, outside
// of the shade, sends light into the wedge under the ball, and each turn between
// floor and ball loses a fifth of it. What the points around say of the ball's
// underside, that it sees a bright floor, is wrong close to where the ball lies.
// The value at (28, 35) is a path tracer's: .088.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  orthographic location <0, 4, -10> direction <0, -.3, 1>
  right 6.4*x up 4.8*y
}
light_source { 1000*y, rgb 1 parallel point_at 0 }
#default { pigment { rgb 1 } finish { ambient 0 diffuse .8 } }
plane { y, 0 }
sphere { y, 1 }
