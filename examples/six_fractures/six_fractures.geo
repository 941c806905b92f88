// SPDX-License-Identifier: BSD-3-Clause
// Rock of 40 m x 30 m with six fractures, some of which cross or end on the outer boundary.
// Shipped meshes: gmsh -2 -format msh41 -bin -setnumber size 1.4 six_fractures.geo
// (0.7 for the fine one). The size is that along the fractures; the pressure gradient is steepest at
// the tips inside the rock, so elements are finer there, and coarser at the corners of the block.
DefineConstant[ size = 1.4 ];
tip = 0.35*size;
corner = 1.2*size;

// Ends of the fractures (m).
ax = -10;  ay = 15;    bx = 10;  by = 7.5;
cx = 5;    cy = 15;    dx = -10; dy = -10;
ex = -10;  ey = -5;    fx = 7.5; fy = -12.5;
gx = -2.5; gy = -2.5;  hx = 2.5; hy = -5;
ix = 12.5; iy = 10;    jx = 10;  jy = 15;
kx = 10;   ky = 2.5;   lx = 0;   ly = -15;

// Crossings: C-D with A-B at the part t from C to D, and so on.
t = ((ax - cx)*(by - ay) - (ay - cy)*(bx - ax))/((dx - cx)*(by - ay) - (dy - cy)*(bx - ax));
cd_ab_x = cx + t*(dx - cx);  cd_ab_y = cy + t*(dy - cy);
t = ((ex - cx)*(fy - ey) - (ey - cy)*(fx - ex))/((dx - cx)*(fy - ey) - (dy - cy)*(fx - ex));
cd_ef_x = cx + t*(dx - cx);  cd_ef_y = cy + t*(dy - cy);
t = ((ex - kx)*(fy - ey) - (ey - ky)*(fx - ex))/((lx - kx)*(fy - ey) - (ly - ky)*(fx - ex));
kl_ef_x = kx + t*(lx - kx);  kl_ef_y = ky + t*(ly - ky);

Point(1) = {-20, -15, 0, corner};
Point(2) = {lx, ly, 0, size};
Point(3) = {20, -15, 0, corner};
Point(4) = {20, 15, 0, corner};
Point(5) = {jx, jy, 0, size};
Point(6) = {cx, cy, 0, size};
Point(7) = {ax, ay, 0, size};
Point(8) = {-20, 15, 0, corner};
Point(9) = {bx, by, 0, tip};
Point(10) = {dx, dy, 0, tip};
Point(11) = {ex, ey, 0, tip};
Point(12) = {fx, fy, 0, tip};
Point(13) = {gx, gy, 0, tip};
Point(14) = {hx, hy, 0, tip};
Point(15) = {ix, iy, 0, tip};
Point(16) = {kx, ky, 0, tip};
Point(17) = {cd_ab_x, cd_ab_y, 0, size};
Point(18) = {cd_ef_x, cd_ef_y, 0, size};
Point(19) = {kl_ef_x, kl_ef_y, 0, size};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Line(11) = {7, 17};   // A-B
Line(12) = {17, 9};
Line(13) = {6, 17};   // C-D
Line(14) = {17, 18};
Line(15) = {18, 10};
Line(16) = {11, 18};  // E-F
Line(17) = {18, 19};
Line(18) = {19, 12};
Line(19) = {13, 14};  // G-H
Line(20) = {15, 5};   // I-J
Line(21) = {16, 19};  // K-L
Line(22) = {19, 2};

// The corner enclosed by A-B, C-D and the top is a surface of its own, as is the part left of the
// chain A-B, C-D, E-F, K-L; the remaining fractures end inside a surface and are embedded.
Curve Loop(1) = {6, 11, -13};
Curve Loop(2) = {1, -22, -17, -14, -11, 7, 8};
Curve Loop(3) = {2, 3, 4, 5, 13, 14, 17, 22};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Curve{15, 16} In Surface{2};
Curve{12, 18, 19, 20, 21} In Surface{3};

Physical Surface("rock") = {1, 2, 3};
Physical Curve("left") = {8};
Physical Curve("right") = {3};
Physical Curve("A-B") = {11, 12};
Physical Curve("C-D") = {13, 14, 15};
Physical Curve("E-F") = {16, 17, 18};
Physical Curve("G-H") = {19};
Physical Curve("I-J") = {20};
Physical Curve("K-L") = {21, 22};
