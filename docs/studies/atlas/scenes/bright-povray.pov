#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <0.0,2.0,0.0> direction <0.0,-1.0,0.0> right <0.5,0.0,0.0> up <0.0,0.0,0.5> }
light_source { <0,100,0> rgb 66468.30161832922 parallel point_at 0 }
plane { y,0 pigment { rgb 1 } finish { diffuse 1 } }
