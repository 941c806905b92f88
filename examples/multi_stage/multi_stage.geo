// SPDX-License-Identifier: BSD-3-Clause
// Rock round a well along x with three notches across it, `spacing` apart, seen from above.
// size: element size where cracks run, m.
// gmsh -2 -format msh41 -bin -o multi_stage.msh multi_stage.geo
// and with -setnumber size 0.04 as multi_stage_coarse.msh
DefineConstant[ size = 0.03, spacing = 0.4, notch = 0.1 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
half = 1.8;

Point(1) = {-half, -half, 0};
Point(2) = {half, -half, 0};
Point(3) = {half, half, 0};
Point(4) = {-half, half, 0};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
For i In {0:2}
  x = (i - 1)*spacing;
  p = 10*(i + 1);
  Point(p + 1) = {x, -notch, 0};
  Point(p + 2) = {x, 0, 0};         // where the well feeds it
  Point(p + 3) = {x, notch, 0};
  Line(p + 1) = {p + 1, p + 2};
  Line(p + 2) = {p + 2, p + 3};
  Curve{p + 1, p + 2} In Surface{1};
EndFor

Field[1] = Box;
Field[1].XMin = -1.75*spacing;
Field[1].XMax = 1.75*spacing;
Field[1].YMin = -0.75;
Field[1].YMax = 0.75;
Field[1].VIn = size;
Field[1].VOut = 6*size;
Field[1].Thickness = 1.2;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

Physical Surface("rock") = {1};
Physical Curve("far") = {1:4};
Physical Curve("stage_1") = {11, 12};
Physical Curve("stage_2") = {21, 22};
Physical Curve("stage_3") = {31, 32};
