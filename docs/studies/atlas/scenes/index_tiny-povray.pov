#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <-3.215992362342437e-08,0.0,0.9999999999999994> direction <3.215992362342437e-08,0.0,-0.9999999999999994> right <9.999999999999994e-13,0.0,3.215992362342437e-20> up <0.0,1e-12,0.0> }
box { <-1e3,-1,-1e3>,<1e3,1,0> pigment { rgb 1 filter 1 } interior { ior 6.431984724684874e-08 } }
plane { z,-1 pigment { gradient x color_map { [0 rgb 0][1 rgb 1] } scale 2 } finish { emission 1 } }
