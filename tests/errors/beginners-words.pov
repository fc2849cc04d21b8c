// What other languages, newer versions and web pages put where something else
// is wanted: one message each, and what to type.
#declare Size = 1;
#debug "size" Size
#debug "next"
shpere { 0, 1 }
fog { fog_type ground distance 10 color rgb 1 }
media { scattering 1 }
rainbow { 42.5 5 }
sphere { 0, 1 pigment { "red" } }
sphere { 0, 1 pigment { "wood.png" } }
#declare Words = dictionary { ["a"]: 1 };
#if (1 &lt; 2) sphere { 0, 1 } #end
#declare Power = 2**3;
isosurface { function { x**2 + y*y - 1 } }
sphere { 0, 1 pigment { facets } }
