#version 3.7;
global_settings { assumed_gamma 1
    photons { count 1000, gather 10, 50 media 20, 2 jitter .3
        max_trace_level 8 adc_bailout 0.01 autostop 0 expand_thresholds .2, 40
        radius .1, 2, .2, 1 save_file "x.ph" }
}
camera { location -3*z look_at 0 }
light_source { -5*z, 1 photons { refraction on reflection off area_light } }
sphere { 0, 1 photons { target 1.5 reflection on, collect off } }
union {
    sphere { 0, 1 photons { target } }
    box { 0, 1 photons { pass_through } }
    photons { refraction on }
}
