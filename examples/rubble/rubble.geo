// SPDX-License-Identifier: BSD-3-Clause
// A stack of 10 by 12 six-sided blocks, parted by fractures, in a tray.
// gmsh -2 -format msh41 -bin -o rubble.msh rubble.geo
side = 0.1;
columns = 10;
rows = 12;
rise = side*Sqrt(3)/2;
Mesh.Algorithm = 5;
// Corners of the blocks lie on a lattice of half a width by half a side.
Macro Corner
  id = 1000*(2 + across) + up + 2;
  If (!Exists(made~{id}))
    made~{id} = 1;
    Point(id) = {across*rise, up*side/2, 0, side};
  EndIf
Return
blocks[] = {};
For j In {0 : rows - 1}
  For i In {0 : columns - 1}
    a = 2*i + 1 + (j % 2);
    b = 3*j + 2;
    ids[] = {};
    For k In {0 : 5}
      across = a + (k == 1 || k == 2 ? -1 : (k == 4 || k == 5 ? 1 : 0));
      up = b + (k == 0 ? 2 : (k == 1 || k == 5 ? 1 : (k == 3 ? -2 : -1)));
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
Point(f) = {-2.2, -0.2, 0, 0.5};
Point(f + 1) = {4, -0.2, 0, 0.5};
Point(f + 2) = {4, 0.8, 0, 0.5};
Point(f + 3) = {3.8, 0.8, 0, 0.5};
Point(f + 4) = {3.8, -0.001, 0, 0.5};
Point(f + 5) = {-2, -0.001, 0, 0.5};
Point(f + 6) = {-2, 0.8, 0, 0.5};
Point(f + 7) = {-2.2, 0.8, 0, 0.5};
c = newl;
For k In {0 : 7}
  Line(c + k) = {f + k, f + (k + 1) % 8};
EndFor
l = newll;
Curve Loop(l) = {c : c + 7};
s = news;
Plane Surface(s) = {l};
Physical Surface("blocks") = {blocks[]};
Physical Surface("tray") = {s};
Physical Curve("faces") = {inside[]};
