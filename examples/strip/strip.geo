// SPDX-License-Identifier: BSD-3-Clause
// Strip of 1 m x 0.2 m. Nodes lie on the centre line, where results are compared.
// shape: 0 triangles as Gmsh places them, 1 right triangles.
// Shipped meshes: gmsh -2 -format msh41 -bin -setnumber size 0.05 -setnumber shape 0 strip.geo
DefineConstant[ size = 0.05, shape = 0 ];

Point(1) = {0, 0, 0, size};
Point(2) = {1, 0, 0, size};
Point(3) = {1, 0.1, 0, size};
Point(4) = {1, 0.2, 0, size};
Point(5) = {0, 0.2, 0, size};
Point(6) = {0, 0.1, 0, size};
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

If (shape == 1)
  Transfinite Curve{1, 4, 7} = Round(1/size) + 1;
  Transfinite Curve{2, 3, 5, 6} = Round(0.1/size) + 1;
  Transfinite Surface{1, 2} Left;
EndIf

Physical Surface("rock") = {1, 2};
Physical Curve("left") = {5, 6};
Physical Curve("right") = {2, 3};
