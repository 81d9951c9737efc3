// Textures: images that are filled once, with all their mips.
#pragma once

#include <span>

#include "renderer/gpu/image.h"

namespace unghost {

/// `texels`: rows from the top, without padding, as desc.format has them. Mips and usage are filled in here.
GpuImage upload_texture(Device& device, GpuImageDesc desc, std::span<const std::byte> texels);

} // namespace unghost
