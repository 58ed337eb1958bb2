# SPDX-License-Identifier: GPL-3.0-or-later
"""One body as a file of each format that Assimp reads: glTF, GLB, COLLADA, 3MF; and broken ones."""
import base64
import io
import json
import random
import re
import struct
import zipfile

POINTS = [(0, 0, 0), (2, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def off(points=POINTS, faces=FACES):
    return (f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("{} {} {}\n".format(*p) for p in points)
            + "".join("3 {} {} {}\n".format(*f) for f in faces)).encode()


def gltf_parts(points=POINTS, faces=FACES, nodes=None, uri=None, **more):
    """The JSON of a glTF file, as a dictionary, and its buffer, which is named by `uri`, if there is one."""
    corners = b"".join(struct.pack("<3f", *p) for p in points)
    indices = b"".join(struct.pack("<3H", *f) for f in faces)
    nodes = nodes or [{"name": "tet", "mesh": 0}]
    children = {child for node in nodes for child in node.get("children", [])}
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [i for i in range(len(nodes)) if i not in children]}],
        "nodes": nodes,
        "meshes": [{"name": "body", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3 * len(faces), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(corners)},
                        {"buffer": 0, "byteOffset": len(corners), "byteLength": len(indices)}],
        "buffers": [{"byteLength": len(corners + indices), **({"uri": uri} if uri else {})}], **more}, corners + indices


def gltf(*given, **named):
    parts, buffer = gltf_parts(*given, **named)
    parts["buffers"][0].setdefault("uri", "data:application/octet-stream;base64," + base64.b64encode(buffer).decode())
    return json.dumps(parts, indent=1).encode()


def glb(*given, **named):
    parts, buffer = gltf_parts(*given, **named)
    return packed_glb(json.dumps(parts).encode(), buffer)


def packed_glb(text, buffer):
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


def dae(points=POINTS, faces=FACES, unit="1", up="Y_UP", matrix="", corners=None, url="#g"):
    numbers = " ".join(str(c) for p in points for c in p)
    corners = corners or " ".join(str(i) for f in faces for i in f)
    params = "".join(f'<param name="{axis}" type="float"/>' for axis in "XYZ")
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{unit}"/><up_axis>{up}</up_axis></asset>
<library_geometries><geometry id="g" name="body"><mesh>
<source id="s"><float_array id="a" count="{3 * len(points)}">{numbers}</float_array>
<technique_common><accessor source="#a" count="{len(points)}" stride="3">{params}</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<triangles count="{len(faces)}"><input semantic="VERTEX" source="#v" offset="0"/><p>{corners}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="vs"><node id="n" name="tet">{matrix and f'<matrix>{matrix}</matrix>'}
<instance_geometry url="{url}"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene>
</COLLADA>
""".encode()


def threemf(*given, **named):
    return packed_3mf(model(*given, **named))


def model(points=POINTS, faces=FACES, unit="millimeter", transform=""):
    vertices = "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*p) for p in points)
    triangles = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*f) for f in faces)
    place = f' transform="{transform}"' if transform else ""
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<model unit="{unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
<object id="1" name="tet" type="model"><mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh></object>
</resources><build><item objectid="1"{place}/></build></model>""".encode()


def packed_3mf(text):
    types, kinds = "http://schemas.openxmlformats.org/package/2006/", "application/vnd."
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, part in (
                ("[Content_Types].xml",
                 f'<Types xmlns="{types}content-types"><Default Extension="rels" ContentType="{kinds}openxmlformats-package.'
                 f'relationships+xml"/><Default Extension="model" ContentType="{kinds}ms-package.3dmanufacturing-3dmodel+xml"/></Types>'),
                ("_rels/.rels",
                 f'<Relationships xmlns="{types}relationships"><Relationship Target="/3D/3dmodel.model" Id="r" '
                 'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'),
                ("3D/3dmodel.model", text)):
            archive.writestr(zipfile.ZipInfo(name), part, zipfile.ZIP_DEFLATED)
    return held.getvalue()


MAKERS = {"gltf": gltf, "glb": glb, "dae": dae, "3mf": threemf}


def with_other_numbers(choose, text):
    """The text with some of its numbers changed: it stays well-formed, and comes as far as Assimp."""
    numbers = list(re.finditer(rb"(?<![\w.])-?\d+(?:\.\d+)?(?![\w.])", text))
    for number in sorted(choose.sample(numbers, choose.randint(1, 3)), key=lambda n: -n.start()):
        other = choose.choice((b"0", b"1", b"2", b"3", b"7", b"255", b"65536", b"4294967295", b"-1", b"0.5", b"1e39", b"1e-50"))
        text = text[:number.start()] + other + text[number.end():]
    return text


def broken(choose, content):
    """The bytes with a few of them changed, left out or repeated, or cut short."""
    content = bytearray(content)
    for _ in range(choose.randint(1, 4)):
        at, kind = choose.randrange(len(content)), choose.randrange(5)
        if kind == 0:
            content[at] = choose.randrange(256)
        elif kind == 1:
            content[at] ^= 1 << choose.randrange(8)
        elif kind == 2:
            del content[at:at + choose.randint(1, 40)]
        elif kind == 3:
            content[at:at] = content[at:at + choose.randint(1, 40)] * choose.choice((1, 1, 50))
        else:
            del content[at:]
        content = content or bytearray(b" ")
    return bytes(content)


def mutant(seed):
    """(ending, bytes): a file of some format that is broken, as bytes or within; the same for a seed."""
    choose = random.Random(seed)
    ending, within = choose.choice(sorted(MAKERS)), choose.randrange(3)
    if within == 0:
        return ending, broken(choose, MAKERS[ending]())
    spoil = with_other_numbers if within == 1 else broken
    if ending == "3mf":
        return ending, packed_3mf(spoil(choose, model()))
    if ending == "dae":
        return ending, spoil(choose, dae(matrix="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"))
    nodes = [{"name": "above", "children": [1], "rotation": [0, 0, 0, 1]}, {"name": "n", "mesh": 0, "translation": [1, 0, 0]}]
    if ending == "gltf":
        return ending, spoil(choose, gltf(nodes=nodes))
    parts, buffer = gltf_parts(nodes=nodes)
    text = json.dumps(parts).encode()
    return ending, packed_glb(*((spoil(choose, text), buffer) if choose.randrange(2) else (text, broken(choose, buffer))))
