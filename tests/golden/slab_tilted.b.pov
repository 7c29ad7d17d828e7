#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 73 adc_bailout 0.0001 }
#default { finish { ambient 0 emission 0 diffuse 0 } }
background { rgb 0 }
camera {
  orthographic
  location <0, 1, 2.598076211353316>
  direction <0, -0.5, -0.8660254037844387>
  right <0.5, 0, 0>
  up <0, 0.43301270189221935, -0.25>
}
plane { <0, 1, 0>, -0.5 texture { pigment { rgb 64 } finish { emission 1 } } }
box {
  <-20, -0.25, -20>, <20, 0, 20>
  texture { pigment { rgb 1 filter 1 } finish { reflection { 0, rgb 1 fresnel on } conserve_energy } }
  interior { ior 1.5 }
}
