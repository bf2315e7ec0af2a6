"""Reads drape.vtp and body.vtp: what the scripts of this folder need of them."""

import re
import struct
import xml.etree.ElementTree as etree
import zlib

import numpy

TYPES = {"Float64": numpy.float64, "Float32": numpy.float32, "Int32": numpy.int32,
         "Int64": numpy.int64, "UInt8": numpy.uint8}


class DrapeFile:
    """Point arrays by name, `points` (n, 3) [m], `triangles` (m, 3), `panels` names."""

    def __init__(self, path):
        data = path.read_bytes()
        mark = re.search(rb"<AppendedData[^>]*>\s*_", data)
        if not mark:
            raise SystemExit(f"error: {path}: found no appended data, expected a drape.vtp or body.vtp")
        self._blob = data[mark.end():]
        root = etree.fromstring(data[:mark.start()] + b"</VTKFile>")
        self._arrays, strings = {}, {}
        for node in root.iter("DataArray"):
            self._arrays[node.get("Name")] = node
        for node in root.iter("Array"):
            strings[node.get("Name")] = node
        points = next(root.iter("Points"))
        self.points = self._read(next(points.iter("DataArray"))).reshape(-1, 3)
        polys = next(root.iter("Polys"))
        by_name = {node.get("Name"): node for node in polys.iter("DataArray")}
        self.triangles = self._read(by_name["connectivity"]).reshape(-1, 3)
        self.panels = []  # of a drape
        if "panel_names" in strings:
            text = self._bytes(int(strings["panel_names"].get("offset")))
            self.panels = [name.decode() for name in text.split(b"\0") if name]

    def _bytes(self, offset):
        """One array: header of UInt64 (blocks, block size, last size, sizes…), then zlib blocks."""
        blocks, _, _ = struct.unpack_from("<QQQ", self._blob, offset)
        sizes = struct.unpack_from(f"<{blocks}Q", self._blob, offset + 24)
        place, parts = offset + 24 + 8 * blocks, []
        for size in sizes:
            parts.append(zlib.decompress(self._blob[place:place + size]))
            place += size
        return b"".join(parts)

    def _read(self, node):
        values = numpy.frombuffer(self._bytes(int(node.get("offset"))), TYPES[node.get("type")])
        count = int(node.get("NumberOfComponents", 1))
        return values.reshape(-1, count) if count > 1 else values

    def __getitem__(self, name):
        return self._read(self._arrays[name])

    def __contains__(self, name):
        return name in self._arrays

    def panel(self, name):
        """The flat panel: uv (n, 2) [m], defined for the vertices of its triangles (k, 3)."""
        own = self["panel_id"] == self.panels.index(name)
        uv = numpy.full((len(self.points), 2), numpy.nan)
        uv[self.triangles[own]] = self["corner_uv"].reshape(-1, 3, 2)[own]
        return uv, self.triangles[own]
