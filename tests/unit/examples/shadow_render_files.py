"""Writes the small meshes that the test of shadow_render's command line needs.

Standard library only, so that nothing of ours or of VTK's is used to judge ours.
"""

import base64
import json
import struct

# A unit cube that stands on y = 0, every face wound to the outside.
POINTS = [(x, y, z) for x in (-0.5, 0.5) for y in (0.0, 1.0) for z in (-0.5, 0.5)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))]


def lines_of(rows):
    return "".join(" ".join(str(value) for value in row) + "\n" for row in rows)


def obj(points=POINTS, faces=QUADS):
    return lines_of([("v",) + tuple(p) for p in points] + [("f",) + tuple(i + 1 for i in f) for f in faces])


def ply_header(form):
    return (f"ply\nformat {form} 1.0\nelement vertex {len(POINTS)}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {len(QUADS)}\nproperty list uchar int vertex_indices\nend_header\n")


def ply_text():
    return ply_header("ascii") + lines_of(POINTS) + lines_of([(4,) + q for q in QUADS])


def ply_binary():
    body = b"".join(struct.pack("<3f", *p) for p in POINTS)
    body += b"".join(struct.pack("<B4i", 4, *q) for q in QUADS)
    return ply_header("binary_little_endian").encode() + body


def stl_text():
    facets = ""
    for triangle in TRIANGLES:
        vertices = "".join("vertex %g %g %g\n" % POINTS[i] for i in triangle)
        facets += "facet normal 0 0 0\nouter loop\n" + vertices + "endloop\nendfacet\n"
    return "solid cube\n" + facets + "endsolid cube\n"


def stl_binary():
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *[c for i in t for c in POINTS[i]], 0) for t in TRIANGLES)
    return b"cube".ljust(80) + struct.pack("<I", len(TRIANGLES)) + body


def vtp():
    def array(kind, name, values, components=1):
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
                + " ".join(str(v) for v in values) + "</DataArray>")
    return ('<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
            f'<Piece NumberOfPoints="{len(POINTS)}" NumberOfPolys="{len(QUADS)}"><Points>'
            + array("Float32", "Points", [c for p in POINTS for c in p], 3) + "</Points><Polys>"
            + array("Int32", "connectivity", [i for q in QUADS for i in q])
            + array("Int32", "offsets", range(4, 4 * len(QUADS) + 1, 4))
            + "</Polys></Piece></PolyData></VTKFile>")


def vtk_header(kind, points=POINTS):
    return (f"# vtk DataFile Version 3.0\ncube\nASCII\nDATASET {kind}\nPOINTS {len(points)} float\n"
            + lines_of(points))


def vtk_polydata():
    return vtk_header("POLYDATA") + f"POLYGONS {len(QUADS)} {5 * len(QUADS)}\n" + lines_of([(4,) + q for q in QUADS])


def vtk_grid():
    return vtk_header("UNSTRUCTURED_GRID") + "CELLS 1 9\n8 0 4 6 2 1 5 7 3\nCELL_TYPES 1\n12\n"


def gltf_document(uri=None):
    """The cube, twice too small and shifted, under a node that undoes both."""
    points = b"".join(struct.pack("<3f", x / 2 - 1, y / 2, z / 2) for x, y, z in POINTS)
    indices = b"".join(struct.pack("<3H", *t) for t in TRIANGLES)
    buffer = {"byteLength": len(points) + len(indices)}
    if uri is None:
        buffer["uri"] = "data:application/octet-stream;base64," + base64.b64encode(points + indices).decode()
    elif uri:
        buffer["uri"] = uri
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1], "translation": [2, 0, 0]}, {"mesh": 0, "scale": [2, 2, 2]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [buffer],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(points)},
                        {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(POINTS), "type": "VEC3",
                       "min": [-1.25, 0, -0.25], "max": [-0.75, 0.5, 0.25]},
                      {"bufferView": 1, "componentType": 5123, "count": 3 * len(TRIANGLES), "type": "SCALAR"}]}
    return document, points + indices


def gltf():
    return json.dumps(gltf_document()[0])


def glb():
    document, binary = gltf_document(uri="")
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks
