// SPDX-License-Identifier: BSD-3-Clause
// Rock of 40 m x 30 m with two fractures that cross; one of them ends at the top.
// gmsh -2 -format msh41 -bin -o coupled_rest.msh coupled_rest.geo
h = 2;
Mesh.Algorithm = 5;
Point(1) = {-20, -15, 0, h};
Point(2) = {20, -15, 0, h};
Point(3) = {20, 15, 0, h};
Point(4) = {8, 15, 0, h};
Point(5) = {-20, 15, 0, h};
Point(6) = {0, 3, 0, h};
Point(7) = {-4, -3, 0, h};
Point(8) = {-10, 8, 0, h};
Point(9) = {9, -1.5, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {4, 6};
Line(7) = {6, 7};
Line(8) = {8, 6};
Line(9) = {6, 9};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Curve{6, 7, 8, 9} In Surface{1};
Physical Surface("rock") = {1};
Physical Curve("bottom") = {1};
Physical Curve("sides") = {2, 5};
Physical Curve("top") = {3, 4};
Physical Curve("steep") = {6, 7};
Physical Curve("gentle") = {8, 9};
