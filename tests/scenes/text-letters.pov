// Letters beyond ASCII are drawn as written, where POV-Ray has blanks: said once.
#version 3.7;
global_settings { assumed_gamma 1 }
text { ttf "timrom.ttf" "Tee" 1, 0 }
text { ttf "timrom.ttf" "Café" 1, 0 }
text { ttf "timrom.ttf" concat("Caf", chr(233)) 1, 0 }
