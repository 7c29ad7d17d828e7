#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { perspective location <0,0,-5524691.595946779> direction z right x*.65 up y*.65 }
sphere { 0,1841563.8653155928 pigment { rgb .5 filter 1 } interior { ior 1.5 } }
plane { z,3683127.7306311857 pigment { checker rgb <.5,.25,1> rgb <1,.5,.25> scale 920781.9326577964 } finish { emission 1 } }
