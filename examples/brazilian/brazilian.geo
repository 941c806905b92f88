// SPDX-License-Identifier: BSD-3-Clause
// A disc of 0.1 m, loaded over arcs of 12 degrees at top and bottom. size: element size, m.
// gmsh -2 -format msh41 -bin -o brazilian.msh brazilian.geo
// and with -setnumber size 0.0018 as brazilian_fine.msh
DefineConstant[ size = 0.0025 ];
Mesh.Algorithm = 5;
r = 0.05;
half = 6*Pi/180;
Point(1) = {0, 0, 0, size};
Point(2) = {r, 0, 0, size};
Point(3) = {r*Sin(half), r*Cos(half), 0, size};
Point(4) = {-r*Sin(half), r*Cos(half), 0, size};
Point(5) = {-r, 0, 0, size};
Point(6) = {-r*Sin(half), -r*Cos(half), 0, size};
Point(7) = {r*Sin(half), -r*Cos(half), 0, size};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 6};
Circle(5) = {6, 1, 7};
Circle(6) = {7, 1, 2};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Physical Surface("disc") = {1};
Physical Curve("top") = {2};
Physical Curve("bottom") = {5};
