"""Colours, textures and attributes of trimesh meshes, as attributes and back."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from trimesh import visual as visuals  # type: ignore[import-not-found,import-untyped,unused-ignore]

from strata_csg import _native
from strata_csg._attributes import Image, Material
from strata_csg._colors import of_materials
from strata_csg._interop import Arrays, attributes_from

ColorVisuals: Any = visuals.ColorVisuals
TextureVisuals: Any = visuals.TextureVisuals
MultiMaterial: Any = visuals.material.MultiMaterial
PBRMaterial: Any = visuals.material.PBRMaterial


def attributes_of(mesh: Any) -> _native.Attributes:
    """What a trimesh.Trimesh carries, but normals and metadata."""
    vertex: Mapping[str, Any] = mesh.vertex_attributes
    face: Mapping[str, Any] = mesh.face_attributes
    visual, channels = mesh.visual, []
    materials: list[Material] = []
    images: list[Image] = []
    if visual.kind == "vertex":
        channels = [_native.Channel("color", visual.vertex_colors, "vertex")]
    elif visual.kind == "face":
        channels = [_native.Channel("color", visual.face_colors, "face")]
    elif visual.kind == "texture" and visual.uv is not None:
        members, numbers = _members(visual, len(mesh.faces))
        materials = [_material_from(member, images) for member in members]
        channels = [_native.Channel("texcoord", visual.uv), _native.Channel("material", numbers, "face")]
    names = {channel.name for channel in channels}
    return attributes_from(_others(vertex, names), _others(face, names), channels, materials, images)


def _others(data: Mapping[str, Any], names: set[str]) -> dict[str, Any]:
    return {name: values for name, values in data.items() if name not in names}


def _members(visual: Any, faces: int) -> tuple[Sequence[Any], NDArray[Any]]:
    """The materials, and which of them each face has."""
    if isinstance(visual.material, MultiMaterial) and visual.face_materials is not None:
        return visual.material.materials, np.asarray(visual.face_materials)
    return [visual.material], np.zeros(faces, np.int32)


def _material_from(material: Any, images: list[Image]) -> Material:
    """Its picture is added to the images."""
    picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    color = getattr(material, "baseColorFactor", None)
    if color is None and not isinstance(material, PBRMaterial):
        color = material.main_color
    metallic, roughness = (getattr(material, f"{name}Factor", None) for name in ("metallic", "roughness"))
    if picture is not None:
        images.append(_encoded(picture, f"texture{len(images)}.png"))
    return Material(
        name=getattr(material, "name", None) or "",
        color=(1.0, 1.0, 1.0, 1.0) if color is None else (np.asarray(color, np.float64) / 255).tolist(),
        metallic=0.0 if metallic is None else metallic,
        roughness=1.0 if roughness is None else roughness,
        image=None if picture is None else len(images) - 1,
    )


def _encoded(picture: Any, name: str) -> Image:
    file = io.BytesIO()
    picture.save(file, "PNG")
    return Image(name, "image/png", file.getvalue())


def visual_of(arrays: Arrays) -> Any:
    """
    The texture, or else the colours, which are taken out of the arrays, or else the colours of materials.

    None where there are none.
    """
    if _columns(arrays.vertex, "texcoord") == 2:
        return _texture_of(arrays)
    for data, role in ((arrays.vertex, "vertex_colors"), (arrays.face, "face_colors")):
        if _columns(data, "color") in (3, 4):
            return ColorVisuals(**{role: data.pop("color")})
    if arrays.materials and "material" in arrays.face:
        return ColorVisuals(face_colors=of_materials(arrays.materials, arrays.face["material"]))
    return None


def _columns(data: Mapping[str, NDArray[Any]], name: str) -> int:
    return data[name].shape[1] if name in data and data[name].ndim == 2 else 0


def _texture_of(arrays: Arrays) -> Any:
    uv = arrays.vertex.pop("texcoord")
    numbers = arrays.face.pop("material", np.full(len(arrays.triangles), -1))
    materials = [_material_of(material, arrays.images) for material in arrays.materials] + [PBRMaterial()]
    numbers = np.where((numbers < 0) | (numbers >= len(materials)), len(materials) - 1, numbers)
    used, places = np.unique(numbers, return_inverse=True)
    if len(used) <= 1:
        return TextureVisuals(uv=uv, material=materials[used[0] if len(used) else -1])
    chosen = MultiMaterial([materials[number] for number in used])
    return TextureVisuals(uv=uv, material=chosen, face_materials=places.reshape(-1))


def _material_of(material: Material, images: Sequence[Image]) -> Any:
    return PBRMaterial(
        name=material.name,
        baseColorFactor=np.rint(255 * np.clip(material.color, 0, 1)).astype(np.uint8),
        metallicFactor=material.metallic,
        roughnessFactor=material.roughness,
        baseColorTexture=None if material.image is None else _decoded(images[material.image]),
    )


def _decoded(image: Image) -> Any:
    """A picture of Pillow; None where that is absent, or knows no such picture."""
    try:
        import PIL.Image  # type: ignore[import-not-found, unused-ignore]
    except ImportError:
        return None
    try:
        return PIL.Image.open(io.BytesIO(image.data))
    except PIL.UnidentifiedImageError:
        return None
