#declare Part = box { 0, 1 }
#declare A = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } };
#declare B = <1, 2, 3, 4, 5>.filter + A[1][2]*pi + 3 - -2;
#declare C = ((B > 1 & A[0][0] <= 2 | !(B != 3)) ? vcross(x, y) : <1, 2, 3>);
#declare D = vdot(C, y) + vlength(C) + min(1, 2, 3) + max(4, 5) + abs(-1)
    + floor(1.5) + ceil(1.5) + int(2.5) + mod(7, 3) + div(7, 2) + pow(2, 8)
    + sqrt(2) + exp(1) + ln(2) + log(10) + sin(1) + cos(1) + tan(1) + asin(1)
    + acos(1) + atan2(1, 2) + sinh(1) + cosh(1) + tanh(1) + degrees(1)
    + radians(90) + rand(seed(7)) + select(-1, 1, 2, 3) + val("1.5")
    + asc("a") + strlen("abc") + strcmp("a", "b") + defined(A) + clock
    + clock_delta + frame_number + image_width + image_height + version
    + dimensions(A) + dimension_size(A, 2) + bitwise_and(6, 3)
    + bitwise_or(1, 2) + bitwise_xor(1, 3) + asinh(1) + acosh(2) + atanh(0.5)
    + file_exists("part.inc") + clock_on + inside(Part, x);
#debug concat(str(D, 5, 2), vstr(3, C, ", ", 0, 3), chr(65), substr("abcd",
    2, 2), strupr("a"), strlwr("B"), "\n\u00e4\"\\\t")
#declare V = vnormalize(C) + vrotate(x, 90*y) + vaxis_rotate(x, y, 30)
    + vturbulence(2, 0.5, 6, x) + min_extent(Part)
    + max_extent(Part);
#declare F = function(x, y, z) { sum(i, 1, 3, i*x) + prod(j, 1, 2, y)
    + pow(x, 2) + select(y, 1, 2) + z*z };
sphere { <F(1, 2, 3), 0, 0>, 1 pigment { rgb C.x*C.y + V.z } }
