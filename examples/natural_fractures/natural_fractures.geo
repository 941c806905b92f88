// SPDX-License-Identifier: BSD-3-Clause
// Rock of 2.4 m by 2.4 m: a crack of 0.3 m from its left side, and a natural fracture across its way.
// size: element size where cracks run, m.
// gmsh -2 -format msh41 -bin -o natural_fractures.msh natural_fractures.geo
// and with -setnumber size 0.04 as natural_fractures_coarse.msh
DefineConstant[ size = 0.03, seed = 0.3, distance = 0.6, up = 0.3, down = 0.45 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
half = 1.2;
width = 2.4;

Point(1) = {0, -half, 0};
Point(2) = {width, -half, 0};
Point(3) = {width, half, 0};
Point(4) = {0, half, 0};
Point(5) = {0, 0, 0};                // mouth, where the fluid enters
Point(6) = {seed, 0, 0};             // tip
Point(7) = {distance, -down, 0};     // ends of the natural fracture
Point(8) = {distance, up, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {5, 6};
Line(7) = {7, 8};
Curve Loop(1) = {1:5};
Plane Surface(1) = {1};
Curve{6, 7} In Surface{1};

Field[1] = Box;
Field[1].XMin = 0;
Field[1].XMax = 1.3;
Field[1].YMin = -0.7;
Field[1].YMax = 0.6;
Field[1].VIn = size;
Field[1].VOut = 5*size;
Field[1].Thickness = 1.2;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

Physical Surface("rock") = {1};
Physical Curve("left") = {4, 5};
Physical Curve("far") = {1:3};
Physical Curve("crack") = {6};
Physical Curve("natural") = {7};
