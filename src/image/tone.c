/* Transfer curves: see tone.h. */
#include "image/tone.h"

#include <math.h>

double tone_srgb_encode(double linear)
{
    if (linear <= 0.0031308)
        return linear * 12.92;
    return 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

double tone_srgb_decode(double encoded)
{
    if (encoded <= 0.04045)
        return encoded / 12.92;
    return pow((encoded + 0.055) / 1.055, 2.4);
}

double tone_encode(double linear, double gamma)
{
    if (gamma == 0)
        return tone_srgb_encode(linear);
    if (gamma == 1)
        return linear;
    return linear > 0 ? pow(linear, 1 / gamma) : 0;
}

double tone_decode(double encoded, double gamma)
{
    if (gamma == 0)
        return tone_srgb_decode(encoded);
    if (gamma == 1)
        return encoded;
    return encoded > 0 ? pow(encoded, gamma) : 0;
}
