// SPDX-License-Identifier: BSD-3-Clause
// Ring between a well of radius 0.1 m and an outer circle of radius 1 m. size: element size, m;
// 0.033 gives triangles as large as equilateral ones with edges of 0.03 m.
// gmsh -2 -format msh41 -bin -o pressurised_well.msh pressurised_well.geo
DefineConstant[ size = 0.033, well_radius = 0.1, outer_radius = 1 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles

Point(1) = {0, 0, 0, size};
For i In {0:1}
  radius = i == 0 ? well_radius : outer_radius;
  p = 10*(i + 1);
  Point(p + 1) = {radius, 0, 0, size};
  Point(p + 2) = {0, radius, 0, size};
  Point(p + 3) = {-radius, 0, 0, size};
  Point(p + 4) = {0, -radius, 0, size};
  Circle(p + 1) = {p + 1, 1, p + 2};
  Circle(p + 2) = {p + 2, 1, p + 3};
  Circle(p + 3) = {p + 3, 1, p + 4};
  Circle(p + 4) = {p + 4, 1, p + 1};
  Curve Loop(i + 1) = {p + 1, p + 2, p + 3, p + 4};
EndFor
Plane Surface(1) = {2, 1};

Physical Surface("rock") = {1};
Physical Curve("wall") = {11:14};
Physical Curve("outer") = {21:24};
