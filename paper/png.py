"""Reading, cropping and writing of 8-bit RGB pictures in PNG, without any library."""

import struct
import zlib


class Picture:
    """Rows of bytes, three per pixel."""

    def __init__(self, width, rows):
        self.width = width
        self.rows = rows

    @property
    def height(self):
        return len(self.rows)

    def pixel(self, x, y):
        return tuple(self.rows[y][3 * x:3 * x + 3])

    def crop(self, top, bottom):
        return Picture(self.width, self.rows[top:bottom])


def size(path):
    """Width and height, from the header alone."""
    with open(path, "rb") as file:
        return struct.unpack(">II", file.read(24)[16:24])


def _undo_filter(kind, line, above):
    """One row without its filter (PNG specification, section 9)."""
    if kind == 0:
        return line
    if kind == 2:
        return bytearray((a + b) & 255 for a, b in zip(line, above))
    for i, value in enumerate(line):
        left = line[i - 3] if i >= 3 else 0
        up = above[i]
        if kind == 1:
            predicted = left
        elif kind == 3:
            predicted = (left + up) >> 1
        else:
            corner = above[i - 3] if i >= 3 else 0
            by_left, by_up, by_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
            predicted = left if by_left <= by_up and by_left <= by_corner else \
                up if by_up <= by_corner else corner
        line[i] = (value + predicted) & 255
    return line


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    position, packed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        chunk = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
            if (depth, color, interlaced) != (8, 2, 0):
                raise ValueError(f"{path}: only 8-bit RGB pictures are read")
        elif kind == b"IDAT":
            packed += chunk
        position += 12 + length
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        begin = y * (stride + 1)
        above = _undo_filter(raw[begin], bytearray(raw[begin + 1:begin + 1 + stride]), above)
        rows.append(above)
    return Picture(width, rows)


def write(path, picture):
    raw = b"".join(b"\0" + bytes(row) for row in picture.rows)
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, chunk in ((b"IHDR", header), (b"IDAT", zlib.compress(raw, 9)), (b"IEND", b"")):
            file.write(struct.pack(">I", len(chunk)) + kind + chunk + struct.pack(">I", zlib.crc32(kind + chunk)))


def write_palette(path, picture):
    """The same with the 256 most frequent colours, coarsened until there are no more; several times smaller."""
    step = 1
    while True:
        step *= 2
        coarse = bytes(min(255, (v + step // 2) // step * step) for v in range(256))
        rows = [bytes(row).translate(coarse) for row in picture.rows]
        colors = {}
        for row in rows:
            for x in range(0, len(row), 3):
                colors.setdefault(row[x:x + 3], len(colors))
        if len(colors) <= 256:
            break
    raw = b"".join(b"\0" + bytes(colors[row[x:x + 3]] for x in range(0, len(row), 3)) for row in rows)
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 3, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, chunk in ((b"IHDR", header), (b"PLTE", b"".join(colors)), (b"IDAT", zlib.compress(raw, 9)),
                            (b"IEND", b"")):
            file.write(struct.pack(">I", len(chunk)) + kind + chunk + struct.pack(">I", zlib.crc32(kind + chunk)))


def halved(picture):
    """Half the width and height; each pixel is the mean of four."""
    rows = []
    for y in range(0, picture.height - 1, 2):
        pairs = [a + b for a, b in zip(picture.rows[y], picture.rows[y + 1])]
        row = bytearray(3 * (picture.width // 2))
        for channel in range(3):
            left, right = pairs[channel::6], pairs[channel + 3::6]
            row[channel::3] = bytes((a + b + 2) >> 2 for a, b in zip(left, right))
        rows.append(row)
    return Picture(picture.width // 2, rows)


def bolder(picture):
    """Half the width and height; each pixel is the darkest of four. Keeps thin lines visible in small prints."""
    rows = []
    for y in range(0, picture.height - 1, 2):
        darkest = [a if a < b else b for a, b in zip(picture.rows[y], picture.rows[y + 1])]
        row = bytearray(3 * (picture.width // 2))
        for channel in range(3):
            row[channel::3] = bytes(map(min, darkest[channel::6], darkest[channel + 3::6]))
        rows.append(row)
    return Picture(picture.width // 2, rows)


def beside(left, right, gap):
    """Two pictures in a row, on white."""
    def padded(picture, y):
        return bytes(picture.rows[y]) if y < picture.height else b"\xff" * (3 * picture.width)
    rows = [padded(left, y) + b"\xff" * (3 * gap) + padded(right, y)
            for y in range(max(left.height, right.height))]
    return Picture(left.width + gap + right.width, rows)


def bands(picture):
    """(top, bottom) of the runs of rows that are not white."""
    found, begin = [], None
    for y, row in enumerate(picture.rows):
        blank = row.count(255) == len(row)
        if not blank and begin is None:
            begin = y
        elif blank and begin is not None:
            found.append((begin, y))
            begin = None
    if begin is not None:
        found.append((begin, picture.height))
    return found


def without_legend(picture, with_title):
    """Cuts off the rows of the legend: at the bottom, each beginning with a patch of colour."""
    parts = bands(picture)
    while parts:
        top, bottom = parts[-1]
        middle = (top + bottom) // 2
        inked = [x for x in range(picture.width // 4) if picture.pixel(x, middle) != (255, 255, 255)]
        if inked and max(picture.pixel(inked[0] + 5, middle)) - min(picture.pixel(inked[0] + 5, middle)) > 30:
            parts.pop()
        else:
            break
    first = parts[0][0] if with_title else parts[1][0]
    return picture.crop(max(0, first - 8), min(picture.height, parts[-1][1] + 8))
