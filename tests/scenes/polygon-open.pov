// A polygon whose outline is not closed is closed, as by POV-Ray, which says so.
camera { location <0.5, 0.5, -2> look_at <0.5, 0.5, 0> }
polygon { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }
