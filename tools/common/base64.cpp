#include "common/base64.h"

#include "core/io/folder_of_model.h"

std::string base64(std::string_view bytes) { return strata::io::base64(bytes); }
