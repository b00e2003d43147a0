// SPDX-License-Identifier: LGPL-2.1-or-later
// Sprocket of the reference drive: 15 teeth, ISO 606 minimum tooth gap form, for a roller of
// 10.16 mm and a pitch of 15.875 mm. Lengths in mm. See README.md.

z  = 15;      // teeth
p  = 15.875;  // pitch
d1 = 10.16;   // roller diameter
da = 81.8;    // outside diameter
bore  = 25;
hub   = 33;   // diameter of the zone that is rigid in elastic models
width = 7.2;

// numbers of cells
n_seat   = 3; // from the bottom of the seat to where the blocks meet
n_end    = 1; // from there to the end of the seat
n_flank  = 3; // flank
n_foot   = 2; // across half a tooth
n_depth  = 2; // below the teeth
n_ring   = 1; // down to the hub
n_hub    = 1; // hub zone
n_layers = 2; // width

// ISO 606, minimum form
d     = p / Sin(Pi / z);
ri    = 0.505 * d1;
re    = 0.12 * d1 * (z + 2);
beta  = (140 - 90 / z) / 2 * Pi / 180; // half the seating angle
Px = (d - d1) / 2 + ri;                // centre of the seat: the arc touches the root circle
Sx = Px - ri * Cos(beta);
Sy = ri * Sin(beta);                   // end of the seat
Cx = Px - (ri + re) * Cos(beta);
Cy = (ri + re) * Sin(beta);            // centre of the flank
// flank meets outside circle
Cn = Sqrt(Cx * Cx + Cy * Cy);
u  = (da * da / 4 - re * re + Cn * Cn) / (2 * Cn);
w  = Sqrt(da * da / 4 - u * u);
Tx = (u * Cx + w * Cy) / Cn;
Ty = (u * Cy - w * Cx) / Cn;

// where three blocks meet at about 60 degrees each
turn = Pi / 3 - Pi / z;
Qx = Px - ri * Cos(turn);
Qy = ri * Sin(turn);
foot = Qx * Cos(Pi / z) + Qy * Sin(Pi / z); // middle of the tooth's foot, radius
rt   = (d - d1) / 2 - 0.35 * p;             // circle below the teeth
share = Pi / z * n_seat / (n_seat + n_foot);
// handles of the curve from the meeting point down to the circle
bisector = (Pi / 2 + Pi / z + 3 * Pi / 2 - turn) / 2;
Hx = rt * Cos(share);
Hy = rt * Sin(share);
handle = 0.4 * Sqrt((Qx - Hx)^2 + (Qy - Hy)^2);

O = newp; Point(O) = {0, 0, -width / 2};

// The points of half a sector with the middle of its gap on +x.
xs[] = {Px - ri, Px, Qx, Sx, Cx, Tx, da / 2 * Cos(Pi / z), foot * Cos(Pi / z),
        rt, Hx, rt * Cos(Pi / z), hub / 2, hub / 2 * Cos(share), hub / 2 * Cos(Pi / z),
        bore / 2, bore / 2 * Cos(share), bore / 2 * Cos(Pi / z),
        Qx + handle * Cos(bisector), (rt + handle) * Cos(share)};
ys[] = {0, 0, Qy, Sy, Cy, Ty, da / 2 * Sin(Pi / z), foot * Sin(Pi / z),
        0, Hy, rt * Sin(Pi / z), 0, hub / 2 * Sin(share), hub / 2 * Sin(Pi / z),
        0, bore / 2 * Sin(share), bore / 2 * Sin(Pi / z),
        Qy + handle * Sin(bisector), (rt + handle) * Sin(share)};

sections_rim[] = {}; sections_hub[] = {};
For k In {0 : z - 1}
  centre = 2 * Pi * k / z;
  For side In {-1 : 1 : 2}
    B = newp;
    For i In {0 : #xs[] - 1}
      y = side * ys[i];
      Point(B + i) = {xs[i] * Cos(centre) - y * Sin(centre),
                      xs[i] * Sin(centre) + y * Cos(centre), -width / 2};
    EndFor
    // bottom and centre of the seat, meeting point, end of the seat, centre and end of the flank,
    // middle of the tooth's tip and foot
    P = B + 1; Q = B + 2; S = B + 3; C = B + 4; T = B + 5; E = B + 6; D = B + 7;
    // circle below the teeth, hub, bore; handles
    B1 = B + 8; Q1 = B + 9; D1 = B + 10; B2 = B + 11; Q2 = B + 12; D2 = B + 13;
    B3 = B + 14; Q3 = B + 15; D3 = B + 16; H1 = B + 17; H2 = B + 18;

    // profile
    l1 = newl; Circle(l1) = {B, P, Q};
    l2 = newl; Circle(l2) = {Q, P, S};
    l3 = newl; Circle(l3) = {S, C, T};
    l4 = newl; Circle(l4) = {T, O, E};
    // tooth
    l5 = newl; Line(l5) = {Q, D};
    l6 = newl; Line(l6) = {D, E};
    // below
    l7  = newl; Line(l7) = {B, B1};
    l8  = newl; Bezier(l8) = {Q, H1, H2, Q1};
    l9  = newl; Line(l9) = {D, D1};
    l10 = newl; Circle(l10) = {B1, O, Q1};
    l11 = newl; Circle(l11) = {Q1, O, D1};
    l12 = newl; Line(l12) = {B1, B2};
    l13 = newl; Line(l13) = {Q1, Q2};
    l14 = newl; Line(l14) = {D1, D2};
    l15 = newl; Circle(l15) = {B2, O, Q2};
    l16 = newl; Circle(l16) = {Q2, O, D2};
    l17 = newl; Line(l17) = {B2, B3};
    l18 = newl; Line(l18) = {Q2, Q3};
    l19 = newl; Line(l19) = {D2, D3};
    l20 = newl; Circle(l20) = {B3, O, Q3};
    l21 = newl; Circle(l21) = {Q3, O, D3};

    Transfinite Curve{l1, l10, l15, l20} = n_seat + 1;
    Transfinite Curve{l2} = n_end + 1;
    Transfinite Curve{l3} = n_flank + 1;
    Transfinite Curve{l4, l5, l11, l16, l21} = n_foot + 1;
    Transfinite Curve{l6} = n_end + n_flank + 1;
    Transfinite Curve{l7, l8, l9} = n_depth + 1;
    Transfinite Curve{l12, l13, l14} = n_ring + 1;
    Transfinite Curve{l17, l18, l19} = n_hub + 1;

    s = news; Curve Loop(s) = {l5, l6, -l4, -l3, -l2}; Plane Surface(s) = {s};
    Transfinite Surface{s} = {Q, D, E, T}; sections_rim[] += s;
    s = news; Curve Loop(s) = {l1, l8, -l10, -l7};     Plane Surface(s) = {s};
    Transfinite Surface{s}; sections_rim[] += s;
    s = news; Curve Loop(s) = {l5, l9, -l11, -l8};     Plane Surface(s) = {s};
    Transfinite Surface{s}; sections_rim[] += s;
    s = news; Curve Loop(s) = {l10, l13, -l15, -l12};  Plane Surface(s) = {s};
    Transfinite Surface{s}; sections_rim[] += s;
    s = news; Curve Loop(s) = {l11, l14, -l16, -l13};  Plane Surface(s) = {s};
    Transfinite Surface{s}; sections_rim[] += s;
    s = news; Curve Loop(s) = {l15, l18, -l20, -l17};  Plane Surface(s) = {s};
    Transfinite Surface{s}; sections_hub[] += s;
    s = news; Curve Loop(s) = {l16, l19, -l21, -l18};  Plane Surface(s) = {s};
    Transfinite Surface{s}; sections_hub[] += s;
  EndFor
EndFor
Recombine Surface{sections_rim[], sections_hub[]};
Coherence; // sectors share the points and curves where they meet

// out[0] is the far side, out[1] the volume, out[2 + i] what curve i of the loop sweeps
volumes_rim[] = {}; volumes_hub[] = {}; flanks[] = {}; bores[] = {};
sides[] = {sections_rim[], sections_hub[]};
For i In {0 : #sections_rim[] - 1}
  out[] = Extrude {0, 0, width} { Surface{sections_rim[i]}; Layers{n_layers}; Recombine; };
  sides[] += out[0]; volumes_rim[] += out[1];
  If (i % 5 == 0)
    flanks[] += {out[4], out[5], out[6]};
  ElseIf (i % 5 == 1)
    flanks[] += out[2];
  EndIf
EndFor
For i In {0 : #sections_hub[] - 1}
  out[] = Extrude {0, 0, width} { Surface{sections_hub[i]}; Layers{n_layers}; Recombine; };
  sides[] += out[0]; volumes_hub[] += out[1]; bores[] += out[4];
EndFor

Physical Surface("tooth flanks") = {flanks[]};
Physical Surface("hub") = {bores[]};
Physical Surface("sides") = {sides[]};
Physical Volume("rim") = {volumes_rim[]};
Physical Volume("hub zone") = {volumes_hub[]};
