#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <-1.0,0.0,1.0> direction <0.7071067811865476,0.0,-0.7071067811865476> right <7.071067811865477e-10,0.0,7.071067811865477e-10> up <0.0,1e-09,0.0> }
box { <-1e7,-1,-1e7>,<1e7,1,0> pigment { rgb 1 filter 1 } interior { ior 1.0000036517412725 } }
plane { z,-273841.963426436 pigment { gradient x color_map { [0 rgb 0][1 rgb 1] } scale 7.999926965916529 translate x*273833.9634994701 } finish { emission 1 } }
