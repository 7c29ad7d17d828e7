#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <-0.6666657113249531,0.0,-0.7453568469824332> direction <0.6666657113249531,0.0,0.7453568469824332> right <7.453568469824332e-13,0.0,-6.666657113249531e-13> up <0.0,1e-12,0.0> }
plane { z,0 pigment { rgb 1 filter 1 } finish { reflection { 0,1 fresnel on } conserve_energy } interior { ior 1.5 } }
plane { z,0.01 pigment { rgb 102.17655361192473 } finish { emission 1 } }
