#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 256 adc_bailout 1e-30 photons { spacing 0.0625 gather 1,100000 radius 0.5 autostop 1 } }
#default { finish { ambient 0 emission 0 diffuse 0 } }
camera { orthographic location <4216965.034285823,2.0,0.0> direction <0.0,-1.0,0.0> right <0.5,0.0,0.0> up <0.0,0.0,0.5> }
light_source { <4216965.034285823,100,0> rgb 0.3183098861837907 parallel point_at <4216965.034285823,0,0> }
plane { y,0 pigment { rgb 1 } finish { diffuse 1 } }
box { <4216961.034285823,3,-4>,<4216969.034285823,3.5,4> pigment { rgb 1 filter 1 } interior { ior 1 } photons { target refraction on reflection off collect off } }
