#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <-0.9999999999999877,0.0,1.5667596113991998e-07> direction <0.9999999999999877,0.0,-1.5667596113991998e-07> right <1.5667596113991998e-16,0.0,9.999999999999877e-10> up <0.0,1e-09,0.0> }
plane { z,0 pigment { rgb 1 filter 1 } finish { reflection { 0,1 fresnel on } conserve_energy } interior { ior 1.5 } }
plane { z,-0.5 pigment { rgb 1097841.160274005 } finish { emission 1 } }
