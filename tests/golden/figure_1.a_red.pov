#version 3.7;
global_settings {
  assumed_gamma 1
  max_trace_level 73
  adc_bailout 0.0001
  photons {
    spacing 0.015625
    radius 0.03125
    gather 0, 1048576
    expand_thresholds 0, 0
    jitter 1
    autostop 1
    load_file "photons.map"
  }
}
#default { finish { ambient 0 emission 0 diffuse 0 } }
background { rgb 0 }
camera {
  perspective
  location <0, 2.2, 6>
  direction <0, -0.19611613513818407, -0.9805806756909202>
  right <0.7646543620234878, 0, 0>
  up <0, 0.5623539682372509, -0.11247079364745019>
}
light_source { <-0.5, 2.9, -1.2> rgb 235955160.00401893 fade_distance 0.0005 fade_power 2 }
plane { <0, 1, 0>, 0 texture { pigment { rgb 0.75 } finish { diffuse 1 } } }
polygon {
  5, <-2.2, 0, -3.4>, <2.2, 0, -3.4>, <2.2, 3.4, -3.4>, <-2.2, 3.4, -3.4>, <-2.2, 0, -3.4>
  texture { pigment { rgb 0.75 } finish { diffuse 1 } }
}
polygon {
  5, <-2.2, 0, 2.1999999999999997>, <-2.2, 0, -3.4>, <-2.2, 3.4, -3.4>, <-2.2, 3.4, 2.1999999999999997>, <-2.2, 0, 2.1999999999999997>
  texture { pigment { rgb 0.7 } finish { diffuse 1 } }
}
polygon {
  5, <2.2, 0, -3.4>, <2.2, 0, 2.1999999999999997>, <2.2, 3.4, 2.1999999999999997>, <2.2, 3.4, -3.4>, <2.2, 0, -3.4>
  texture { pigment { rgb 0.35 } finish { diffuse 1 } }
}
polygon {
  5, <-2.2, 3.4, -3.4>, <2.2, 3.4, -3.4>, <2.2, 3.4, 2.1999999999999997>, <-2.2, 3.4, 2.1999999999999997>, <-2.2, 3.4, -3.4>
  texture { pigment { rgb 0.75 } finish { diffuse 1 } }
}
sphere {
  <0.75, 0.6, 0.5>, 0.5998749999999999
  texture {
    average
    texture_map {
      [0.9 pigment { rgb 0.888888888888889 filter 1 }
        finish { reflection { rgb 0.11111111111111112 } }]
      [0.09999999999999998 pigment { rgb 1.0000000000000002 } finish { diffuse 1 }]
    }
  }
  interior_texture {
    average
    texture_map {
      [0.9 pigment { rgb 0.888888888888889 filter 1 }
        finish { reflection { rgb 0.11111111111111112 } }]
      [0.09999999999999998 pigment { rgb 0.4444444444444445 } finish { diffuse 1 }]
    }
  }
  interior { ior 1.5 }
  photons { target refraction on reflection on }
}
sphere {
  <-0.75, 0.6, -0.4>, 0.6
  texture { pigment { rgb 0.15 } finish { diffuse 1 reflection { rgb 0.8 } } }
  photons { target refraction off reflection on }
}
