// SPDX-License-Identifier: BSD-3-Clause
// gmsh -2 -format msh41 -bin -o dam.msh dam.geo
h = 0.25;
Point(1) = {0, 0, 0, h};
Point(2) = {5, 0, 0, h};
Point(3) = {5, 1, 0, h};
Point(4) = {5, 6, 0, h};
Point(5) = {0, 6, 0, h};
Point(6) = {0, 5, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Physical Surface("earth") = {1};
Physical Curve("upstream") = {6};
Physical Curve("downstream") = {2};
Physical Curve("face") = {3};
