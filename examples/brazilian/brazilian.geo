// SPDX-License-Identifier: BSD-3-Clause
// A disc of 0.1 m, loaded over arcs of 12 degrees at top and bottom.
// straight: 1 where edges of triangles follow the loaded diameter, 0 where the sizes of triangles
// vary so that no direction is preferred. size: mean element size, m.
// gmsh -2 -format msh41 -bin -o brazilian.msh brazilian.geo
// and with -setnumber straight 1 as brazilian_straight.msh
DefineConstant[ size = 0.0016, straight = 0 ];
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
If (straight)
  Point(8) = {0, 0.9*r, 0, size};
  Point(9) = {0, -0.9*r, 0, size};
  Line(7) = {8, 9};
  Curve{7} In Surface{1};
Else
  Field[1] = MathEval;
  Field[1].F = Sprintf("%g*(1 + 0.25*Sin(1100*x)*Sin(900*y + 1))", size);
  Background Field = 1;
  Mesh.CharacteristicLengthFromPoints = 0;
  Mesh.CharacteristicLengthExtendFromBoundary = 0;
EndIf
Physical Surface("disc") = {1};
Physical Curve("top") = {2};
Physical Curve("bottom") = {5};
