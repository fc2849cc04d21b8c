// A warning begins a line of its own, whatever the scene has said.
#version 3.7;
global_settings { assumed_gamma 1 }
#debug "one, "
#debug "two"
#warning "three"
#debug "four\n"
#warning "five"
#debug ""
camera { location -5 * z }
