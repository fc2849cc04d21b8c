/* Sine, cosine and arc tangent of NUMBERS, a vector of doubles, with BITS, the
 * vector of as many int64_t; octet_math.c includes it for each such vector, of
 * which there are choose and less as in octet.h, and names the functions with
 * NAMED.
 *
 * Angles are taken modulo pi/2, which is subtracted in three parts of 27 bits,
 * whose multiples up to 2^26 are exact, and a last one (Cody and Waite,
 * "Software Manual for the Elementary Functions", 1980). The polynomials are
 * minimax ones: those of sine and cosine between -pi/4 and pi/4 have the
 * coefficients of Sun's fdlibm (1993), the quotient of the arc tangent those of
 * Moshier's Cephes library (1989). */

INLINED NUMBERS NAMED(magnitude)(NUMBERS x)
{
    return (NUMBERS)((BITS)x & INT64_MAX);
}

/* x as the quarter turns nearest to it, modulo 4 in the lowest bits, and the
 * rest. */
INLINED BITS NAMED(quarters)(NUMBERS x, NUMBERS *rest)
{
    const double whole =
        0x1.8p52; /* so large that nothing is after the point */
    NUMBERS turned = x * 0x1.45f306dc9c883p-1 + whole, count = turned - whole;
    x = x - count * 0x1.921fb54p+0;
    x = x - count * 0x1.10b461p-30;
    x = x - count * 0x1.a62633p-58;
    *rest = x - count * 0x1.45c06e0e68948p-86;
    return (BITS)turned;
}

INLINED NUMBERS NAMED(sine_near)(NUMBERS x, NUMBERS z)
{
    NUMBERS sum = 1.58969099521155010221e-10 * z - 2.50507602534068634195e-08;
    sum = sum * z + 2.75573137070700676789e-06;
    sum = sum * z - 1.98412698298579493134e-04;
    sum = sum * z + 8.33333333332248946124e-03;
    sum = sum * z - 1.66666666666666324348e-01;
    return x + x * z * sum;
}

INLINED NUMBERS NAMED(cosine_near)(NUMBERS z)
{
    NUMBERS sum = -1.13596475577881948265e-11 * z + 2.08757232129817482790e-09;
    sum = sum * z - 2.75573143513906633035e-07;
    sum = sum * z + 2.48015872894767294178e-05;
    sum = sum * z - 1.38888888888741095749e-03;
    sum = sum * z + 4.16666666666666019037e-02;
    return 1 - (0.5 * z - z * z * sum);
}

/* The sine of x and `ahead` quarter turns, of angles up to angle_limit. */
INLINED NUMBERS NAMED(sine_ahead)(NUMBERS x, int64_t ahead)
{
    NUMBERS rest;
    BITS turns = NAMED(quarters)(x, &rest) + ahead;
    NUMBERS z = rest * rest;
    BITS odd = -(turns & 1), negative = (turns & 2) << 62;
    NUMBERS value =
        NAMED(choose)(odd, NAMED(cosine_near)(z), NAMED(sine_near)(rest, z));
    return (NUMBERS)((BITS)value ^ negative);
}

/* Of what is below the tangent of pi/8 or so. */
INLINED NUMBERS NAMED(arc_near)(NUMBERS x)
{
    NUMBERS z = x * x;
    NUMBERS above = -8.750608600031904122785e-1 * z - 1.615753718733365076637e1;
    above = above * z - 7.500855792314704667340e1;
    above = above * z - 1.228866684490136173410e2;
    above = above * z - 6.485021904942025371773e1;
    NUMBERS below = z + 2.485846490142306297962e1;
    below = below * z + 1.650270098316988542046e2;
    below = below * z + 4.328810604912902668951e2;
    below = below * z + 4.853903996359136964868e2;
    below = below * z + 1.945506571482613964425e2;
    return x + x * (z * above / below);
}

/* Of numbers up to arc_limit. The angle of the eighth of the plane, then of the
 * half, then of the plane. */
INLINED NUMBERS NAMED(arc_of)(NUMBERS y, NUMBERS x)
{
    const double pi_half = 0x1.921fb54442d18p0,
                 pi_half_rest = 0x1.1a62633145c07p-54;
    NUMBERS across = NAMED(magnitude)(x), high = NAMED(magnitude)(y),
            zero = { 0 };
    BITS steep = NAMED(less)(across, high);
    NUMBERS large = NAMED(choose)(steep, high, across);
    NUMBERS small = NAMED(choose)(steep, across, high);
    NUMBERS slope =
        NAMED(choose)(NAMED(less)(zero, large), small / large, zero);
    BITS far = NAMED(less)(zero + 0.41421356237309503, slope);
    NUMBERS near = NAMED(choose)(far, (slope - 1) / (slope + 1), slope);
    NUMBERS angle = NAMED(arc_near)(near);
    NUMBERS quarter = NAMED(choose)(far, zero + pi_half / 2, zero);
    NUMBERS rest = NAMED(choose)(far, zero + pi_half_rest / 2, zero);
    angle = quarter + (angle + rest);
    angle = NAMED(choose)(steep, pi_half - (angle - pi_half_rest), angle);
    BITS back = (BITS)x >> 63;
    angle =
        NAMED(choose)(back, 2 * pi_half - (angle - 2 * pi_half_rest), angle);
    return (NUMBERS)((BITS)angle | ((BITS)y & INT64_MIN));
}
