#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 2 adc_bailout 0.0001 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
background { rgb 0 }
camera {
  perspective
  location <0, 32, 0>
  direction <0, -1, 0>
  right <1.091910702798607, 0, 0>
  up <0, 0, -0.7279404685324047>
}
light_source { <0, 32, 0> rgb 3183098.861837907 fade_distance 0.032 fade_power 2 }
plane { <0, 1, 0>, 0 texture { pigment { rgb <0.18, 0.5, 0.9> } finish { diffuse 1 } } }
