// SPDX-License-Identifier: BSD-3-Clause
// Level ground in which a bench of 20 m is cut, steep by `face`. A joint that dips by `dip` comes out
// of the face 4 m above the toe; a vertical crack goes from the ground down to it. size: of the
// elements of the block above the joint, m.
// gmsh -2 -format msh41 -bin -o slope.msh slope.geo
DefineConstant[ size = 1.4, face = 60, dip = 35, height = 20, out = 4, back = 20 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
far = 5;
steep = Tan(face*Pi/180);
lower = out + (back - out/steep)*Tan(dip*Pi/180);
Point(1) = {-25, -15, 0, far};
Point(2) = {50, -15, 0, far};
Point(3) = {50, height, 0, far};
Point(4) = {back, height, 0, size};
Point(5) = {height/steep, height, 0, size};
Point(6) = {-25, height, 0, far};
Point(7) = {-25, 0, 0, 2*size};
Point(8) = {0, 0, 0, size};
Point(9) = {out/steep, out, 0, size};
Point(10) = {back, lower, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 1};
Line(8) = {7, 8};
Line(9) = {8, 9};
Line(10) = {9, 5};
Line(11) = {9, 10};
Line(12) = {10, 4};
Curve Loop(1) = {1, 2, 3, -12, -11, -9, -8, 7};
Curve Loop(2) = {11, 12, 4, -10};
Curve Loop(3) = {8, 9, 10, 5, 6};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Physical Surface("rock") = {1};
Physical Surface("block") = {2};
Physical Surface("cut") = {3};
Physical Curve("bottom") = {1};
Physical Curve("sides") = {2, 6, 7};
Physical Curve("joint") = {11};
Physical Curve("crack") = {12};
Physical Curve("ground") = {3, 4, 5};
