// SPDX-License-Identifier: BSD-3-Clause
// A column of 8 by 14 six-sided blocks, parted by fractures, on a floor.
// gmsh -2 -format msh41 -bin -o rubble.msh rubble.geo
side = 0.1;
columns = 8;
rows = 14;
rise = side*Sqrt(3)/2;
Mesh.Algorithm = 5;
// Corners of the blocks lie on a lattice of half a side by half a height.
Macro Corner
  id = 1000*(2 + across) + up + 2;
  If (!Exists(made~{id}))
    made~{id} = 1;
    Point(id) = {across*side/2, up*rise, 0, side};
  EndIf
Return
blocks[] = {};
For i In {0 : columns - 1}
  For j In {0 : rows - 1}
    a = 3*i;
    b = 2*j + 1 + (i % 2);
    ids[] = {};
    For k In {0 : 5}
      across = a + (k == 0 ? 2 : (k == 1 || k == 5 ? 1 : (k == 3 ? -2 : -1)));
      up = b + (k == 1 || k == 2 ? 1 : (k == 4 || k == 5 ? -1 : 0));
      Call Corner;
      ids[] += id;
    EndFor
    lines[] = {};
    For k In {0 : 5}
      c = newl;
      Line(c) = {ids[k], ids[(k + 1) % 6]};
      lines[] += c;
    EndFor
    l = newll;
    Curve Loop(l) = {lines[]};
    s = news;
    Plane Surface(s) = {l};
    blocks[] += s;
  EndFor
EndFor
Coherence;
outside[] = Abs(CombinedBoundary{ Surface{blocks[]}; });
inside[] = Abs(Boundary{ Surface{blocks[]}; });
inside[] -= outside[];
f = newp;
Point(f) = {-3, -0.2, 0, 0.5};
Point(f + 1) = {4, -0.2, 0, 0.5};
Point(f + 2) = {4, -0.001, 0, 0.5};
Point(f + 3) = {-3, -0.001, 0, 0.5};
c = newl;
Line(c) = {f, f + 1};
Line(c + 1) = {f + 1, f + 2};
Line(c + 2) = {f + 2, f + 3};
Line(c + 3) = {f + 3, f};
l = newll;
Curve Loop(l) = {c, c + 1, c + 2, c + 3};
s = news;
Plane Surface(s) = {l};
Physical Surface("blocks") = {blocks[]};
Physical Surface("floor") = {s};
Physical Curve("faces") = {inside[]};
