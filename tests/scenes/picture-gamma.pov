#version 3.7;
global_settings { assumed_gamma 1 }
// The gamma of a picture's numbers, said by the scene: of light files, and where
// numbers are no colours.
#declare Ball = sphere { 0, 1 }
#macro Heights (Field)
  #for (I, 0, 3)
    #declare At = trace(Field, <(I + .5) / 4, 9, (I + .5) / 4>, -y);
    #debug concat(str(At.y, 0, 3), " ")
  #end
  #debug "\n"
#end
#macro Values (Of)
  #for (I, 0, 3)
    #debug concat(str(Of((I + .5) / 4, (I + .5) / 4, 0), 0, 3), " ")
  #end
  #debug "\n"
#end
Heights(height_field { png "../render/parts/heights8.png" gamma 2.2 })
Heights(height_field { png "../render/parts/heights16.png" gamma srgb })
Heights(height_field { png "../render/parts/heights_colour.png" gamma 2 })
Heights(height_field { exr "../render/parts/light.exr" gamma 2 })
#declare Grey = function { pattern { image_pattern { png "../render/parts/heights8.png" gamma 2.2 } } }
Values(Grey)
#declare Palette = function { pattern { image_pattern { png "../render/parts/flag.png" gamma 2 } } }
Values(Palette)
#declare Exr = function { pigment { image_map { exr "../render/parts/light.exr" gamma 2 } } }
#declare Hdr = function { pigment { image_map { hdr "../render/parts/light.hdr" gamma 2 } } }
#declare Red = function(x, y, z) { Exr(x, y, z).red } Values(Red)
#declare Red_2 = function(x, y, z) { Hdr(x, y, z).red } Values(Red_2)
object { Ball pigment { rgb 1 } }
