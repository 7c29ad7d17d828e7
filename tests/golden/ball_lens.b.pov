#version 3.7;
global_settings {
  assumed_gamma 1
  max_trace_level 4
  adc_bailout 0.0001
  photons {
    spacing 0.10502100630210073
    radius 0.25
    gather 0, 1048576
    expand_thresholds 0, 0
    jitter 1
    autostop 1
    load_file "photons.map"
  }
}
#default { finish { ambient 0 emission 0 diffuse 0 } }
background { rgb 0 }
camera { orthographic location <0, 4, 0> direction <0, -1, 0> right <20.8, 0, 0> up <0, 0, -20.8> }
light_source { <0, 16384, 0> rgb 0.9960957421875001 parallel point_at <0, 0, 0> }
plane { <0, 1, 0>, 0 texture { pigment { rgb 0.8 } finish { diffuse 1 } } }
sphere {
  <0, 16, 0>, 8
  texture { pigment { rgb 1 filter 1 } }
  interior { ior 1.5 }
  photons { target refraction on reflection off collect off }
}
