"""CBOR (RFC 8949) with the typed arrays of RFC 8746, decoded to what json.loads gives: an oracle that shares no code with Pliant.

`python3 cbor.py < FILE` prints each item of a sequence (RFC 8742) as a line of JSON."""
import json
import math
import struct
import sys

FLOATS = {80: ">e", 81: ">f", 82: ">d", 84: "<e", 85: "<f", 86: "<d"}
INTEGERS = {64: "B", 65: ">H", 66: ">I", 67: ">Q", 68: "B", 69: "<H", 70: "<I", 71: "<Q",
            72: "b", 73: ">h", 74: ">i", 75: ">q", 77: "<h", 78: "<i", 79: "<q"}
BREAK = object()


def decode(data, at=0):
    """The item that starts there, and where it ends."""
    major, low = data[at] >> 5, data[at] & 31
    at += 1
    if low < 24:
        value = low
    elif low < 28:
        size = 1 << (low - 24)
        raw = data[at:at + size]
        assert len(raw) == size, "the data end within a number"
        value, at = int.from_bytes(raw, "big"), at + size
    else:
        assert low == 31 and major in (2, 3, 4, 5, 7), f"additional information {low} of major type {major}"
        value = None  # of a length that is not given
    if major == 0:
        return value, at
    if major == 1:
        return -1 - value, at
    if major in (2, 3):
        if value is None:
            parts = []
            while (item := decode(data, at))[0] is not BREAK:
                parts.append(item[0])
                at = item[1]
            return (b"" if major == 2 else "").join(parts), at + 1
        assert at + value <= len(data), "the data end within a string"
        raw = bytes(data[at:at + value])
        return (raw if major == 2 else raw.decode("utf-8")), at + value
    if major in (4, 5):
        items = []
        while value is None or len(items) < value * (major - 3):
            item, at = decode(data, at)
            if item is BREAK:
                assert value is None and (major == 4 or len(items) % 2 == 0), "a break where there is none"
                break
            items.append(item)
        if major == 4:
            return items, at
        names = items[::2]
        assert all(isinstance(name, str) for name in names) and len(set(names)) == len(names), "names of members"
        return dict(zip(names, items[1::2])), at
    if major == 6:
        item, at = decode(data, at)
        form = FLOATS.get(value) or INTEGERS.get(value)
        if form is None:
            return item, at  # a tag that says nothing about the value, such as 55799
        assert isinstance(item, bytes) and len(item) % struct.calcsize(form) == 0, f"the bytes of tag {value}"
        numbers = [number for number, in struct.iter_unpack(form, item)]
        assert all(math.isfinite(number) for number in numbers), "numbers that are not finite"
        return numbers, at
    if low in (25, 26, 27):
        return struct.unpack({25: ">e", 26: ">f", 27: ">d"}[low], raw)[0], at
    if value is None:
        return BREAK, at
    return {20: False, 21: True, 22: None, 23: None}[value], at


def sequence(data):
    """Every item of a sequence."""
    at = 0
    while at < len(data):
        item, at = decode(data, at)
        assert item is not BREAK, "a break outside of an item"
        yield item


if __name__ == "__main__":
    for each in sequence(sys.stdin.buffer.read()):
        print(json.dumps(each, ensure_ascii=False, allow_nan=False))
