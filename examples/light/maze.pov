// A maze of corridors, closed on all sides, with one lamp at its entrance: a
// corner or two away there is only light that has bounced many times. The
// picture is the plan, drawn from just under the ceiling; black is wall.
//   glim maze.pov +W500 +H500 --lighting path
//   Declare=View=1         down the first corridor
//   Declare=Albedo=0.5     how much of the light the walls give back
//   Declare=Radiosity=1    POV-Ray's radiosity, glim's indirect light mesh
//   Declare=Points=160     writes maze.points (points.inc)
// maze-table.points has the seven places A to G, in the middle of the floor,
// from the lamp inwards.
#version 3.7;
#ifndef (View) #declare View = 0; #end
#ifndef (Albedo) #declare Albedo = 0.5; #end
#ifndef (Radiosity) #declare Radiosity = 0; #end
global_settings {
  assumed_gamma 1
  #if (Radiosity)
    radiosity { count 400 error_bound 0.5 recursion_limit 4 }
  #end
}
#default { finish { ambient 0 diffuse Albedo } }

// # is wall, L the lamp, A to G the seven places. The first line is the far
// side. Even lines and columns are thin, for walls, odd ones wide, to walk.
#declare Plan = array[9] {
  "#########",
  "#  G F  #",
  "# ### # #",
  "# # # #E#",
  "# # ### #",
  "# #C#  D#",
  "### ### #",
  "#L A B  #",
  "#########"
}
#declare Rows = dimension_size(Plan, 1);
#declare Columns = strlen(Plan[0]);
#declare Thin = 0.3;
#declare Wide = 1.6;
#declare Height = 2.4;
// Where line or column I begins, and the middle of an odd one.
#declare Place = function(I) {
  floor(I / 2) * (Thin + Wide) + mod(I, 2) * Thin
}
#declare Middle = function(I) { Place(I) + Wide / 2 }
#declare Size = Place(Columns);

#if (View)
  camera {
    location <Middle(5), 1.7, Middle(1) - 0.5>
    look_at <Middle(7), 1.2, Middle(3)>
    right x * image_width / image_height
    angle 80
  }
#else
  camera {
    orthographic
    location <Size / 2, Height - 0.01, Size / 2>
    direction -y right Size * x * image_width / image_height up Size * z
  }
#end

light_source {
  <Middle(1), 1.9, Middle(1)>, <64, 60, 54>
  fade_distance 0.5 fade_power 2
}

#macro Letter(Row, Column)
  substr(Plan[Rows - 1 - Row], Column + 1, 1)
#end
// Each run of # is one box.
#macro Walls()
  box { <0, -0.2, 0>, <Size, 0, Size> pigment { rgb <1, 0.9, 0.75> } }
  box { <0, Height, 0>, <Size, Height + 0.2, Size> pigment { rgb 1 } }
  #for (Row, 0, Rows - 1)
    #local Start = -1;
    #for (Column, 0, Columns)
      #local Wall = 0;
      #if (Column < Columns)
        #local Wall = (strcmp(Letter(Row, Column), "#") = 0);
      #end
      #if (Wall & Start < 0)
        #local Start = Column;
      #end
      #if (!Wall & Start >= 0)
        box {
          <Place(Start), 0, Place(Row)>, <Place(Column), Height, Place(Row + 1)>
          pigment { rgb <0.9, 0.95, 1> }
        }
        #local Start = -1;
      #end
    #end
  #end
#end
Walls()

#ifdef (Points)
  #include "points.inc"
  // Every place where one can walk, and the seven in order of their letters.
  #declare Void = array[(Rows - 1) * (Columns - 1) / 4][2]
  #declare Open = 0;
  #for (Row, 1, Rows - 2, 2)
    #for (Column, 1, Columns - 2, 2)
      #declare Void[Open][0] = <Place(Column), 0, Place(Row)> + 0.1;
      #declare Void[Open][1] =
        <Place(Column) + Wide, Height, Place(Row) + Wide> - 0.1;
      #declare Open = Open + 1;
    #end
  #end
  Write_Points("maze.points", union { Walls() }, Void, Points)
  #fopen Table "maze-table.points" write
  #for (I, 1, 7)
    #for (Row, 1, Rows - 2, 2)
      #for (Column, 1, Columns - 2, 2)
        #if (strcmp(Letter(Row, Column), substr("ABCDEFG", I, 1)) = 0)
          #write (Table, str(Middle(Column), 0, 3), " 0.001 ",
                  str(Middle(Row), 0, 3), " 0 1 0\n")
        #end
      #end
    #end
  #end
  #fclose Table
#end
