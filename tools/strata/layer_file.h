#pragma once
#include <string>

#include "strata/query.h"

/// Writes the pieces of a decomposition as a binary PLY file, whole or not at all: faces with the list vertex_indices,
/// a colour (uchar red, green, blue) per layer, the layer (int, 0 for flat faces, which are grey) and the solid (int).
/// Corners that were made by cuts are rounded to the nearest doubles. Throws strata::IoError.
void write_layers(const std::string& path, const strata::LayerDecomposition& layers);

/// The same faces and colours as a picture, in glTF 2.0 (.glb): in units of the scene's size, since glTF has floats
/// only. Throws strata::IoError.
void write_layer_picture(const std::string& path, const strata::LayerDecomposition& layers);
