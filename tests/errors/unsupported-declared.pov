#declare Blob = blob { threshold .5 sphere { 0, 1, 1 } }
sphere { 0, 1 }
object { Blob }
