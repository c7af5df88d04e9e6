#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "strata/contact.h"

/// What was found out about a pair of parts.
struct PairFacts {
  strata::contact::RelatedPair pair;
  strata::contact::ContactRegion region = {};  ///< of a contact
  strata::Solid overlap = {};                  ///< of parts that interfere
  strata::contact::Nearest nearest = {};       ///< of parts that are apart
};

/// Writes the parts, grey, or dark where they interfere with some other one, and the facets and edges of their
/// contacts, in a colour per pair, as a binary PLY file, whole or not at all: faces with the list vertex_indices, a
/// colour (uchar red, green, blue), the part (int, -1 for contacts) and the pair (int, -1 for parts); edges with
/// vertex1, vertex2, the colour and the pair. Places are rounded to the nearest doubles. Throws strata::IoError.
void write_contacts(const std::string& path, const strata::contact::Assembly& parts,
                    const std::vector<PairFacts>& pairs);

/// A picture of the same (.glb): parts are pulled apart, and either of two shows where it touches the other one, by
/// facets a little above its surface. Throws strata::IoError.
void write_contact_picture(const std::string& path, const strata::contact::Assembly& parts,
                           const std::vector<PairFacts>& pairs);
