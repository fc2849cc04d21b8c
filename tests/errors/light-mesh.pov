global_settings { light_mesh { qualty 7 } }
global_settings { light_mesh { quality 11 } }
global_settings { light_mesh { density 0 } }
global_settings { light_mesh { model direct } }
global_settings { light_mesh { shadows 3 } }
global_settings { light_mesh { interpolation 3 } }
global_settings { light_mesh { save_file "x" } }
global_settings { light_mesh { load_file "x" } }
global_settings { light_mesh { indirect { sample 3 } } }
global_settings { light_mesh { region { 0, 1 } } }
global_settings { light_mesh { region { 0, 1 factor 0 } } }
global_settings { skeleton { resolution 1e6 } }
global_settings { skeleton { heuristics a } }
global_settings { radiosity { counts 1 } }
global_settings { lightmesh { } }
global_settings { light_mesh { indirect of } }
global_settings { light_mesh { indirect { samples 2000000 skeleton yess } } }
sphere { 0, 1 hollow flase pigment { rgb 1 } }
sphere { 0, 1 hollow pigmnt { rgb 1 } }
