light_group { light_source { y, rgb 1 } global_light on }
light_group { Lamps }
union { light_group { sphere { 0, 1 } } }
