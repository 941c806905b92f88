// SPDX-License-Identifier: BSD-3-Clause
// A crack of 1 m along the middle of a thin block of rock.
// Shipped mesh: gmsh -2 -format msh41 -bin filling.geo
DefineConstant[ size = 0.005 ];

Point(1) = {0, -size, 0};
Point(2) = {1, -size, 0};
Point(3) = {1, 0, 0};
Point(4) = {1, size, 0};
Point(5) = {0, size, 0};
Point(6) = {0, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {6, 3};
Curve Loop(1) = {1, 2, -7, 6};
Curve Loop(2) = {7, 3, 4, 5};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve{1, 4, 7} = Round(1/size) + 1;
Transfinite Curve{2, 3, 5, 6} = 2;
Transfinite Surface{1, 2} Alternated;

Physical Surface("rock") = {1, 2};
Physical Curve("left") = {5, 6};
Physical Curve("crack") = {7};
