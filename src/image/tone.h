/* From the working space of the scene to the numbers of a file (section 5.9
 * of notes/povray.md). */
#ifndef IMAGE_TONE_H
#define IMAGE_TONE_H

/* The sRGB transfer curve (IEC 61966-2-1), odd for negative values. */
double tone_srgb_encode(double linear);
double tone_srgb_decode(double encoded);

#endif
