// SPDX-License-Identifier: BSD-3-Clause
// Rock below a dam with a flat base from x = -20 m (heel) to 20 m (toe), with two vertical lines of
// `depth` below heel and gallery (curtain). The rock ends at a half ellipse whose foci are heel and toe: a line
// of flow. width: half of the rock, m; size: smallest element size, m.
// gmsh -2 -format msh41 -bin -o dam_foundation.msh dam_foundation.geo
DefineConstant[ half = 20, width = 100, place = -12, depth = 12, size = 0.25 ];
bottom = Sqrt(width*width - half*half);
far = 8;
Point(1) = {-width, 0, 0, far};
Point(2) = {-half, 0, 0, size};
Point(3) = {place, 0, 0, size};
Point(4) = {place + 1, 0, 0, 2*size};
Point(5) = {half, 0, 0, size};
Point(6) = {width, 0, 0, far};
Point(7) = {0, -bottom, 0, far};
Point(8) = {0, 0, 0, 2};
Point(9) = {-half, -depth, 0, 2*size};
Point(10) = {place, -depth, 0, 2*size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 8};
Line(5) = {8, 5};
Line(6) = {5, 6};
Ellipse(7) = {6, 8, 6, 7};
Ellipse(8) = {7, 8, 1, 1};
Line(9) = {2, 9};
Line(10) = {3, 10};
Curve Loop(1) = {1 : 8};
Plane Surface(1) = {1};
Curve{9, 10} In Surface{1};
Physical Surface("rock") = {1};
Physical Curve("reservoir") = {1};
Physical Curve("gallery") = {3};
Physical Curve("tail water") = {6};
Physical Curve("heel") = {9};
Physical Curve("curtain") = {10};
