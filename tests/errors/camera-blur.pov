camera { aperture 1 blur_samples 5, -2 }
camera { blur_samples 1e9 }
sphere { 0, 1 }
