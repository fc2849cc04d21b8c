// What glim alone reads in global_settings, and radiosity, which it only notes.
#version 3.7;
#declare Points = 3;
#declare Thing = box { 0, <1, 2, 3> }
global_settings {
  assumed_gamma 1
  radiosity { count 200, 1000 error_bound 0.5 normal on nearest_count 10 5 }
#ifdef (Glim)
  light_mesh {
    quality 7 density Points*2 radius 0.4 interpolation spherical
    model scalar shadows sharp threshold 0.1 levels 3
    indirect { samples 100 bounces 2 }
    indirect off
    region { <1, 1, 1>, 0 factor 4 }
    region { min_extent(Thing), max_extent(Thing) factor 2 }
    load_file "light-mesh.pov"
  }
  skeleton { resolution 64 heuristic network }
#end
}
