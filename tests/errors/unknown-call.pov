M(1)
sphere { 0, 1 M(1) }
sphere { 0, Sqr(2) }
sphere { 0, f_noise(1, 1, 1) }
object { Round_Box(0, 1, 0.1, 0) }
