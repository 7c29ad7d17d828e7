#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <0.0,0.0,-10.0> direction <0.0,0.0,1.0> right <0.1,0.0,0.0> up <0.0,0.1,0.0> }
box { <-1,-1,0>,<1,1,9.646616199111996e-05> pigment { rgb .5 filter 1 } interior { ior 1.5 } }
plane { z,5 pigment { rgb 1.0 } finish { emission 1 } }
