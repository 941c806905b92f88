// SPDX-License-Identifier: BSD-3-Clause
// A square of 10 m that a closed fracture cuts obliquely.
// gmsh -2 -format msh41 -bin -o in_situ.msh in_situ.geo
h = 1;
Mesh.Algorithm = 5;
Point(1) = {0, 0, 0, h};
Point(2) = {10, 0, 0, h};
Point(3) = {10, 10, 0, h};
Point(4) = {0, 10, 0, h};
Point(5) = {2, 4, 0, h};
Point(6) = {8, 7, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve{5} In Surface{1};
Physical Surface("rock") = {1};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Curve("fracture") = {5};
