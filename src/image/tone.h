/* Transfer curves: what stands in files <-> linear light. */
#ifndef IMAGE_TONE_H
#define IMAGE_TONE_H

/* The sRGB transfer curve (IEC 61966-2-1). Its straight foot goes on below
 * zero, as in POV-Ray (measured: srgb -0.2 decodes to -0.01548). */
double tone_srgb_encode(double linear);
double tone_srgb_decode(double encoded);

/* v^(1/gamma) and v^gamma; below zero 0, as in POV-Ray (measured). gamma 0
 * stands for the sRGB curve. */
double tone_encode(double linear, double gamma);
double tone_decode(double encoded, double gamma);

#endif
