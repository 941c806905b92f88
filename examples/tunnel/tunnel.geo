// SPDX-License-Identifier: BSD-3-Clause
// Rock of 24 m by 24 m with a tunnel of 2 m to be excavated. size: element size at its wall, m.
// gmsh -2 -format msh41 -bin -o tunnel.msh tunnel.geo
DefineConstant[ size = 0.12 ];
Mesh.Algorithm = 5;
far = 2;
Point(1) = {0, 0, 0, 3*size};
radius[] = {1, 2.5};
For i In {0 : 1}
  r = radius[i];
  Point(10*i + 11) = {r, 0, 0, size};
  Point(10*i + 12) = {0, r, 0, size};
  Point(10*i + 13) = {-r, 0, 0, size};
  Point(10*i + 14) = {0, -r, 0, size};
  Circle(10*i + 11) = {10*i + 11, 1, 10*i + 12};
  Circle(10*i + 12) = {10*i + 12, 1, 10*i + 13};
  Circle(10*i + 13) = {10*i + 13, 1, 10*i + 14};
  Circle(10*i + 14) = {10*i + 14, 1, 10*i + 11};
  Curve Loop(10*i + 11) = {10*i + 11 : 10*i + 14};
EndFor
Point(31) = {-12, -12, 0, far};
Point(32) = {12, -12, 0, far};
Point(33) = {12, 12, 0, far};
Point(34) = {-12, 12, 0, far};
Line(31) = {31, 32};
Line(32) = {32, 33};
Line(33) = {33, 34};
Line(34) = {34, 31};
Curve Loop(31) = {31 : 34};
Plane Surface(1) = {11};
Plane Surface(2) = {21, 11};
Plane Surface(3) = {31, 21};
Point{1} In Surface{1};
Physical Surface("tunnel") = {1};
Physical Surface("near") = {2};
Physical Surface("far") = {3};
Physical Curve("outer") = {31 : 34};
