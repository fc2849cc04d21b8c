sphere { 0, 1 texture { pigment { rgb x } finish { Shiny } } }
global_settings { radiosity { count 50 pretrace 0.1 } }
