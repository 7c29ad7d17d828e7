#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { perspective location <0,0,-0.0003469072231909727> direction z right x*.65 up y*.65 }
sphere { 0,0.00011563574106365757 pigment { rgb .5 filter 1 } interior { ior 1.5 } }
plane { z,0.00023127148212731514 pigment { checker rgb <.5,.25,1> rgb <1,.5,.25> scale 5.7817870531828784e-05 } finish { emission 1 } }
