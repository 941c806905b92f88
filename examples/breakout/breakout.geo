// SPDX-License-Identifier: BSD-3-Clause
// A block of 1.6 m by 1.6 m with a hole of 0.1 m radius in its middle; within 0.17 m of the centre it may
// break. A rim 0.03 m wide parts this rock from the one without joints. size: element size at the
// wall, m.
// gmsh -2 -format msh41 -bin -o breakout.msh breakout.geo
DefineConstant[ size = 0.0045, half = 0.8 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
far = 0.25;
Point(1) = {0, 0, 0, size};
radius[] = {0.1, 0.17, 0.2};
growth[] = {1, 1.8, 2.2};
For i In {0 : 2}
  r = radius[i];
  h = growth[i]*size;
  p = 10*(i + 1);
  Point(p + 1) = {r, 0, 0, h};
  Point(p + 2) = {0, r, 0, h};
  Point(p + 3) = {-r, 0, 0, h};
  Point(p + 4) = {0, -r, 0, h};
  Circle(p + 1) = {p + 1, 1, p + 2};
  Circle(p + 2) = {p + 2, 1, p + 3};
  Circle(p + 3) = {p + 3, 1, p + 4};
  Circle(p + 4) = {p + 4, 1, p + 1};
  Curve Loop(i + 1) = {p + 1 : p + 4};
EndFor
Point(41) = {-half, -half, 0, far};
Point(42) = {half, -half, 0, far};
Point(43) = {half, half, 0, far};
Point(44) = {-half, half, 0, far};
Line(41) = {41, 42};
Line(42) = {42, 43};
Line(43) = {43, 44};
Line(44) = {44, 41};
Curve Loop(4) = {41 : 44};
Plane Surface(1) = {2, 1};
Plane Surface(2) = {3, 2};
Plane Surface(3) = {4, 3};
Physical Surface("near") = {1};
Physical Surface("rim") = {2};
Physical Surface("far") = {3};
Physical Curve("wall") = {11 : 14};
Physical Curve("sides") = {42, 44};
Physical Curve("ends") = {41, 43};
