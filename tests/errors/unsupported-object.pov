blob { threshold .5 sphere { 0, 1, 1 } }
