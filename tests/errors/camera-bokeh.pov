camera { aperture 1 blur_samples 9 bokeh { rgb 1 } }
camera { aperture 1 blur_samples 9 bokeh }
