"""glTF files that are right but unusual, and what is said of those that cannot be read: shadow_render_gltf.py PROGRAM."""

import base64
import json
import pathlib
import struct
import subprocess
import tempfile
import unittest

from shadow_render_case import PROGRAM, Picture

POINTS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
INDICES = [i for a, b, c, d in QUADS for i in (a, b, c, a, c, d)]
BUFFER = b"".join(struct.pack("<3f", *point) for point in POINTS) + struct.pack("<36H", *INDICES)


def document(uri="data:application/octet-stream;base64," + base64.b64encode(BUFFER).decode()):
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.5, 0.2, 1.0]}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
                        {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "buffers": [{"byteLength": len(BUFFER), **({"uri": uri} if uri else {})}]}


def textured(uri):
    result = document()
    result["images"] = [{"uri": uri}]
    result["textures"] = [{"source": 0}]
    material = result["materials"][0]
    material["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    material["normalTexture"] = {"index": 0}
    return result


def coloured(component, form, kind="VEC3"):
    """Red corners. component, form: glTF's number of the components' type and struct's letter."""
    most = {"f": 1.0, "B": 255, "H": 65535}[form]
    # Rows of whole 4 bytes, as glTF asks for; alpha, which an opaque material does not look at, is 0.
    row = [most, 0, 0] + [0] * (1 if kind == "VEC4" or form != "f" else 0)
    data = BUFFER + 8 * struct.pack("<%d%s" % (len(row), form), *row)
    result = document("data:application/octet-stream;base64," + base64.b64encode(data).decode())
    result["buffers"][0]["byteLength"] = len(data)
    result["bufferViews"].append({"buffer": 0, "byteOffset": 168, "byteLength": len(data) - 168,
                                  "byteStride": struct.calcsize(form) * len(row)})
    result["accessors"].append({"bufferView": 2, "componentType": component, "count": 8, "type": kind,
                                "normalized": form != "f"})
    result["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2
    return result


def blended(mode, alpha):
    result = document()
    result["materials"][0].update(alphaMode=mode)
    result["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][3] = alpha
    return result


def binary():
    text = json.dumps(document(uri=None)).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(BUFFER), 0x004E4942) + BUFFER
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


class Gltf(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def run_with(self, content, name="mesh.gltf"):
        data = content if isinstance(content, bytes) else json.dumps(content).encode()
        (self.folder / name).write_bytes(data)
        return subprocess.run([PROGRAM, name, "--size", "160x120", "--mask", "mask.png", "--output", "picture.png"],
                              cwd=self.folder, capture_output=True, text=True)

    def draw(self, content, name="mesh.gltf"):
        run = self.run_with(content, name)
        self.assertEqual(run.returncode, 0, run.stderr)
        return (self.folder / "mask.png").read_bytes(), run.stderr

    def refuse(self, content, *words):
        run = self.run_with(content)
        self.assertEqual(run.returncode, 1)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_same_mask(self):
        plain, said = self.draw(document())
        self.assertEqual(said, "")
        (self.folder / "two words.bin").write_bytes(BUFFER)
        variants = {
            "upper case": (document(), "MESH.GLTF"), "binary": (binary(), "mesh.glb"),
            "binary, upper case": (binary(), "MESH.GLB"),
            "buffer with an encoded name": (document(uri="two%20words.bin"), "mesh.gltf"),
            "buffer with a blank in its name": (document(uri="two words.bin"), "mesh.gltf")}
        for name, (content, file) in variants.items():
            with self.subTest(name):
                mask, said = self.draw(content, file)
                self.assertEqual(mask, plain)
                self.assertEqual(said, "")

    def test_textures_are_not_needed(self):
        plain, _ = self.draw(document())
        for uri in ("none.png", "tex%20ture.webp"):
            mask, said = self.draw(textured(uri))
            self.assertEqual(mask, plain)
            self.assertIn("warning", said)
            self.assertIn(uri.replace("%20", " "), said)
        (self.folder / "broken.png").write_bytes(b"no picture")
        mask, said = self.draw(textured("broken.png"))
        self.assertEqual(mask, plain)

    def count_red(self):
        picture = Picture(self.folder / "picture.png")
        pixels = [picture.pixel(x, y) for x in range(160) for y in range(120)]
        return sum(red > 40 and green < red / 3 for red, green, *_ in pixels)

    def test_vertex_colours(self):
        plain, _ = self.draw(document())
        self.assertEqual(self.count_red(), 0)
        for component, form, kind in ((5126, "f", "VEC3"), (5121, "B", "VEC3"), (5123, "H", "VEC3"), (5121, "B", "VEC4")):
            with self.subTest(form + kind):
                mask, said = self.draw(coloured(component, form, kind))
                self.assertEqual((mask, said), (plain, ""))
                self.assertGreater(self.count_red(), 1000)

    def test_translucent_materials(self):
        plain, _ = self.draw(document())
        self.assertTrue(Picture(self.folder / "mask.png").shadow())
        seen = (self.folder / "picture.png").read_bytes()
        mask, said = self.draw(blended("BLEND", 0.4))
        self.assertEqual(Picture(self.folder / "mask.png").shadow(), set())
        self.assertIn("translucent", said)
        self.assertNotEqual((self.folder / "picture.png").read_bytes(), seen)
        for mode, alpha in (("BLEND", 1.0), ("OPAQUE", 0.4), ("MASK", 0.6)):
            with self.subTest(mode):
                self.assertEqual(self.draw(blended(mode, alpha)), (plain, ""))
        self.refuse(blended("MASK", 0.4), "holds no triangles")

    def test_what_is_missing_is_named(self):
        self.refuse(document(uri="gone.bin"), "gone.bin", "not there")
        self.refuse(b"{ no json", "JSON")

    def test_extensions_are_named(self):
        for extension in ("KHR_draco_mesh_compression", "KHR_mesh_quantization", "EXT_meshopt_compression"):
            self.refuse({**document(), "extensionsRequired": [extension], "extensionsUsed": [extension]}, extension)


if __name__ == "__main__":
    unittest.main()
