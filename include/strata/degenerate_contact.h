#pragma once
/// What operations give where boundaries meet without crossing properly: the specification. It declares nothing.
///
/// Words: a *piece* is a part of one operand's surface that no other surface divides. It has an outer side, where its
/// normal points, and an inner side. A *sheet* is the surface on one side of an edge. An edge or a vertex is *manifold*
/// if the sheets there are one surface: two sheets at an edge, one fan of triangles at a vertex.
///
/// **Laws.** All degenerate cases follow from these; none has a rule of its own.
///
/// 1. *Regular.* The result is the closure of the interior of what the operation gives as a set. A piece belongs to its
///    boundary exactly when the points close to it are in the result on one side and not on the other. So there are no
///    walls, dangling faces or edges, nor isolated points, and solids that only touch have an empty intersection.
/// 2. *Exact.* Contact is decided on the coordinates given. One ulp apart is no contact; one ulp inside is an overlap.
/// 3. *One piece for all.* Where pieces coincide, in whatever triangles, at most one stays. It is that of the lowest
///    face: of the first operand, in the order in which the operation was given them, and there of the first triangle.
///    Its `Source` says so, and nothing else depends on it. (Of four and more solids in a union, those that have walls
///    in common may be united first; they count where the first of them stands.)
/// 4. *Oriented.* A piece that stays is turned over if the result is on its outer side.
/// 5. *Once.* Sheets that meet in the result share their vertices and edges: each is written once, whoever listed it,
///    and is non-manifold if more than one surface passes. So two parts that touch are one component of the mesh. The
///    exception: a vertex that one operand lists twice stays two where no other operand touches it.
/// 6. *Complete.* No vertex of the result lies inside an edge or a triangle of it, so it passes `check`.
/// 7. *Nothing needless.* Contact that leaves no trace in the result leaves no divided faces: these come back in few
///    triangles, or untouched. A vertex of another operand that lies on an edge of a face may stay on the edge.
///
/// **Pieces.** The whole of the semantics for two operands, by laws 1, 3 and 4. `a`: a piece of A stays, `-a`: it stays
/// turned over, `.`: nothing stays. Same side: the interiors of A and B are on one side of the piece.
///
/// | piece                      | union | intersection | A - B | B - A | symmetric difference |
/// |----------------------------|-------|--------------|-------|-------|----------------------|
/// | of A, outside B            | a     | .            | a     | .     | a                    |
/// | of A, inside B             | .     | a            | .     | -a    | -a                   |
/// | of B, outside A            | b     | .            | .     | b     | b                    |
/// | of B, inside A             | .     | b            | -b    | .     | -b                   |
/// | of both, on the same side  | a     | a            | .     | .     | .                    |
/// | of both, on opposite sides | .     | .            | a     | b     | .                    |
///
/// With more operands, or a `Formula`, a point close to the piece on either side is in some of the operands; the
/// operation tells from these whether it is in the result.
///
/// **Contacts.** A is the first operand and B the last. A - B is the first without all others, B - A the last without
/// all others. Outside, inside: B touches A from there. Crossing: their interiors overlap, and neither contains the
/// other.
///
/// | cell | the result                                                                                  |
/// |------|---------------------------------------------------------------------------------------------|
/// | 0    | is empty: no triangles, no vertices                                                         |
/// | A    | is A as a point set; B: is B                                                                |
/// | AB   | has the boundaries of A and of B, apart; B's is turned over where B is taken away           |
/// | a    | has the piece that coincides with others from A; b: from B                                  |
/// | .    | has no piece where operands have coinciding pieces, and is manifold                         |
/// | m    | is manifold: pieces of A and of B follow one another                                        |
/// | v    | has a non-manifold vertex, written once, and no such edge                                   |
/// | e    | has a non-manifold edge, written once                                                       |
///
/// | contact                                        | union | intersection | A - B | B - A | sym. difference |
/// |------------------------------------------------|-------|--------------|-------|-------|-----------------|
/// | no contact, apart                              | AB    | 0            | A     | B     | AB              |
/// | no contact, one ulp apart                      | AB    | 0            | A     | B     | AB              |
/// | no contact, nested                             | A     | B            | AB    | 0     | AB              |
/// | vertex on vertex, outside                      | v     | 0            | A     | B     | v               |
/// | vertex on vertex, inside                       | A     | B            | v     | 0     | v               |
/// | vertex on edge, outside                        | v     | 0            | A     | B     | v               |
/// | vertex on edge, inside                         | A     | B            | v     | 0     | v               |
/// | vertex on face, outside                        | v     | 0            | A     | B     | v               |
/// | vertex on face, inside                         | A     | B            | v     | 0     | v               |
/// | vertex on face, crossing                       | m     | m            | m     | m     | e               |
/// | edge through vertex, outside                   | v     | 0            | A     | B     | v               |
/// | edge through vertex, crossing                  | m     | m            | m     | m     | e               |
/// | edge across edge, outside                      | v     | 0            | A     | B     | v               |
/// | edge across edge, crossing                     | m     | m            | m     | m     | e               |
/// | edge on edge, equal                            | e     | 0            | A     | B     | e               |
/// | edge on edge, overlapping                      | e     | 0            | A     | B     | e               |
/// | edge on edge, inside                           | A     | B            | e     | 0     | e               |
/// | edge in face, outside                          | e     | 0            | A     | B     | e               |
/// | edge in face, inside                           | A     | B            | e     | 0     | e               |
/// | edge in face, crossing                         | m     | m            | m     | m     | e               |
/// | coplanar faces, same side, equal               | A a   | B a          | .     | 0     | .               |
/// | coplanar faces, same side, contained           | A a   | B a          | .     | 0     | .               |
/// | coplanar faces, same side, overlapping         | m a   | m a          | .     | .     | e               |
/// | coplanar faces, opposite sides, equal          | .     | 0            | A a   | B b   | .               |
/// | coplanar faces, opposite sides, contained      | .     | 0            | A a   | B b   | .               |
/// | coplanar faces, opposite sides, overlapping    | .     | 0            | A a   | B b   | .               |
/// | coplanar faces, same side, edge in common      | e     | 0            | A     | B     | e               |
/// | coplanar faces, opposite sides, edge in common | e     | 0            | A     | B     | e               |
/// | coplanar faces, vertex in common               | v     | 0            | A     | B     | v               |
/// | identical operands                             | A a   | A a          | 0     | 0     | 0               |
/// | equal operands in other triangles              | A a   | A a          | 0     | 0     | 0               |
/// | operand touches itself in an edge              | e     | 0            | A e   | B     | e               |
/// | operand touches itself in a vertex             | v     | 0            | A v   | B     | v               |
/// | operand touches itself, listed apart           | e     | 0            | A e   | B     | e               |
/// | operand listed apart, another touches it there | e     | 0            | A e   | B     | e               |
/// | result touches itself                          | A a   | 0            | e     | 0     | e               |
/// | several through one vertex                     | v     | 0            | A     | B     | v               |
/// | several about one edge                         | e     | 0            | A     | B     | e               |
/// | several in one plane, same side                | B a   | A a          | 0     | .     | a               |
/// | several in one plane, both sides               | .     | 0            | 0     | .     | a               |
/// | several, two of them united first              | b     | 0            | A     | .     | .               |
/// | several fill an operand                        | .     | 0            | 0     | .     | .               |
/// | empty operand                                  | A     | 0            | A     | 0     | A               |
/// | flat operand                                   | A     | 0            | A     | 0     | A               |
/// | all operands empty                             | 0     | 0            | 0     | 0     | 0               |
/// | only a wall in common                          | .     | 0            | A a   | .     | e a             |
///
/// *Edge across edge*: they cross in one point. *Listed apart*: the operand has vertices of its own for each sheet;
/// where no other operand touches these, they stay two (law 5), and `topology` counts them as one. *Several in one
/// plane, both sides*: two are on one side and one is on the other; the symmetric difference is on the other side only,
/// so A's piece bounds it, turned over. *Two of them united first*: the last coincides with the third and has a wall in
/// common with the second (law 3). *Several fill an operand*: the others cover the first, with a wall between them
/// inside it. *Flat operand*: it has no volume; since it is no solid, its class is `InputClass::overlapping` or
/// `repair`. *Only a wall in common*: A has a wall in common with two others, which cross each other there.
///
/// Engines: all give these solids. Which face counts (law 3) and which vertices stay (law 7) is said of the
/// arrangement; other engines choose triangles of their own.
///
/// Tests: tests/support/contact_rows.cpp has the same rows with solids that meet so, exact volumes, facets,
/// non-manifold edges and vertices, and the area that comes from each operand. tests/csg/degenerate_contact_test.cpp
/// asks for all of it, for every cell above, and that both tables have the same rows;
/// tests/bsp/degenerate_contact_test.cpp asks the other engines.
///
/// How it is done: lib/core/overlap/theory.md, lib/core/select/theory.md. Source: Requicha 1980; Requicha and Voelcker
/// 1985, "Boolean operations in solid modeling", where a piece is judged by the neighbourhoods on both sides of it.
