/* Calls, lists and strings as other languages write them. */
#macro M(P, Q) sphere { P, Q } #end
M(P=0, Q=1)
M(P: 0, Q: 1)
#declare F = function(x, y) { x + y };
#declare A = F(x=1, y=2);
#declare A = { 1, 2, 3 };
#declare B = [1, 2];
#declare C = if (1) 2 else 3;
#declare D = 'single';
#declare E = PI;
#declare E = math.sin(1);
#declare E = sqrt 4;
#declare E = rand();
#declare E = "n: " + 5;
#declare E = vec3(1, 2, 3);
#declare List = array[2] { 1, 2 };
#declare E = List.length;
#declare E[2] = { 1, 2 };
#declare None[2] = { 1, 2 };
#declare Ball2.5 = 1;
#declare "Quoted" = 1;
#declare E 1;
