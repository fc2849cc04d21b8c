// A prism whose Bezier outline is not closed is left out, as by POV-Ray.
prism {
  bezier_spline 0, 1, 8,
  <-1, 0>, <-1, 1>, <0, 1>, <0, 0>
  <0, 0>, <0, 1>, <1, 1>, <1, 0>
}
