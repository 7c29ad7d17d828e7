#version 3.7;
global_settings {
  assumed_gamma 1
  max_trace_level 65
  adc_bailout 0.0001
  photons {
    spacing 0.21004201260420147
    radius 0.5
    gather 0, 1048576
    expand_thresholds 0, 0
    jitter 1
    autostop 1
    save_file "photons.map"
  }
}
#default { finish { ambient 0 emission 0 diffuse 0 } }
background { rgb 0 }
camera { orthographic location <0, 16, 0> direction <0, -1, 0> right <25.6, 0, 0> up <0, 0, -25.6> }
light_source { <0, 16384, 0> rgb 1.229747829861111 parallel point_at <0, 0, 0> }
plane { <0, 1, 0>, 0 texture { pigment { rgb 0.8 } finish { diffuse 1 } } }
box {
  <-16, 24, -16>, <16, 25.6, 16>
  texture {
    average
    texture_map { [0.9 pigment { rgb 1 filter 1 }] [0.09999999999999998 pigment { rgb 0 }] }
  }
  interior { ior 1.5 }
  photons { target refraction on reflection off collect off }
}
