#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 2 adc_bailout 0.0001 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
background { rgb 0 }
camera {
  perspective
  location <0, 64, 0>
  direction <0, -1, 0>
  right <1.091910702798607, 0, 0>
  up <0, 0, -0.7279404685324047>
}
light_source { <0, 13107.2, 9830.4> rgb 61.11549814728781 parallel point_at <0, 0, 0> }
plane { <0, 1, 0>, 0 texture { pigment { rgb <0.18, 0.5, 0.9> } finish { diffuse 1 } } }
