// SPDX-License-Identifier: BSD-3-Clause
// A block of 0.2 m by 0.1 m lies on a slope that falls to the left. angle: of the slope, degree.
// gmsh -2 -format msh41 -bin -o incline.msh incline.geo
// and with -setnumber angle 25 as incline_25.msh
DefineConstant[ angle = 35 ];
h = 0.05;
// A point given by its distance along the slope, up, and from it.
Macro Place
  Point(n) = {along*Cos(angle*Pi/180) - away*Sin(angle*Pi/180),
              along*Sin(angle*Pi/180) + away*Cos(angle*Pi/180), 0, size};
Return
size = 2*h;
n = 1; along = 0; away = -0.1; Call Place;
n = 2; along = 1.2; away = -0.1; Call Place;
n = 3; along = 1.2; away = 0; Call Place;
n = 6; along = 0; away = 0; Call Place;
size = h;
n = 4; along = 1.1; away = 0; Call Place;
n = 5; along = 0.9; away = 0; Call Place;
n = 7; along = 1.1; away = 0.1; Call Place;
n = 8; along = 0.9; away = 0.1; Call Place;
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {4, 7};
Line(8) = {7, 8};
Line(9) = {8, 5};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Curve Loop(2) = {-4, 7, 8, 9};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Surface("slope") = {1};
Physical Surface("block") = {2};
Physical Curve("base") = {4};
