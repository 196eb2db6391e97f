// SPDX-License-Identifier: Apache-2.0
#include "dioptre/codecs/codecs.h"
#include "dioptre/io/image/codec_module.h"

extern "C" const dioptre::CodecModule dioptre_codecs{
    .decode_tiff = dioptre::codecs::decode_tiff,
    .decode_exr = dioptre::codecs::decode_exr,
    .encode_exr = dioptre::codecs::encode_exr,
};
