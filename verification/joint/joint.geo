// SPDX-License-Identifier: BSD-3-Clause
// Two squares of 0.1 m, one above the other, of two triangles each: a single joint between them.
// gmsh -2 -format msh41 -bin -o joint.msh joint.geo
Point(1) = {0, -0.1, 0, 1};
Point(2) = {0.1, -0.1, 0, 1};
Point(3) = {0.1, 0, 0, 1};
Point(4) = {0, 0, 0, 1};
Point(5) = {0.1, 0.1, 0, 1};
Point(6) = {0, 0.1, 0, 1};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {3, 5};
Line(6) = {5, 6};
Line(7) = {6, 4};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {-3, 5, 6, 7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve {1:7} = 2;
Transfinite Surface {1, 2};
Physical Surface("lower") = {1};
Physical Surface("upper") = {2};
Physical Curve("bottom") = {1};
Physical Curve("joint") = {3};
Physical Curve("top") = {6};
