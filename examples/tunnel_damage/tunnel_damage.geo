// SPDX-License-Identifier: BSD-3-Clause
// Rock of 32 m by 32 m with a tunnel of 2 m radius to be excavated; within `near` of the axis the
// elements are as small as at the wall. size: element size there, m.
// gmsh -2 -format msh41 -bin -o tunnel_damage.msh tunnel_damage.geo
DefineConstant[ size = 0.17, near = 4 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
far = 4;
Point(1) = {0, 0, 0, 4*size};
radius[] = {2, near};
For i In {0 : 1}
  r = radius[i];
  p = 10*(i + 1);
  Point(p + 1) = {r, 0, 0, size};
  Point(p + 2) = {0, r, 0, size};
  Point(p + 3) = {-r, 0, 0, size};
  Point(p + 4) = {0, -r, 0, size};
  Circle(p + 1) = {p + 1, 1, p + 2};
  Circle(p + 2) = {p + 2, 1, p + 3};
  Circle(p + 3) = {p + 3, 1, p + 4};
  Circle(p + 4) = {p + 4, 1, p + 1};
  Curve Loop(i + 1) = {p + 1, p + 2, p + 3, p + 4};
EndFor
Point(31) = {-16, -16, 0, far};
Point(32) = {16, -16, 0, far};
Point(33) = {16, 16, 0, far};
Point(34) = {-16, 16, 0, far};
Line(31) = {31, 32};
Line(32) = {32, 33};
Line(33) = {33, 34};
Line(34) = {34, 31};
Curve Loop(3) = {31 : 34};
Plane Surface(1) = {1};
Plane Surface(2) = {2, 1};
Plane Surface(3) = {3, 2};
Point{1} In Surface{1};
Physical Surface("tunnel") = {1};
Physical Surface("near") = {2};
Physical Surface("far") = {3};
Physical Curve("outer") = {31 : 34};
