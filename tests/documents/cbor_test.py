#!/usr/bin/env python3
"""The decoder of CBOR that other tests compare with decodes what the RFCs print."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cbor

# Appendix A of RFC 8949; typed arrays as RFC 8746 has them.
CASES = {
    "00": 0, "17": 23, "1818": 24, "1903e8": 1000, "1b000000e8d4a51000": 10**12, "20": -1, "3903e7": -1000,
    "1bffffffffffffffff": 2**64 - 1, "f93c00": 1.0, "f97bff": 65504.0, "fa47c35000": 100000.0, "fb3ff199999999999a": 1.1,
    "f90001": 5.960464477539063e-08, "f4": False, "f5": True, "f6": None, "6449455446": "IETF", "62c3bc": "\u00fc", "80": [],
    "83010203": [1, 2, 3], "8301820203820405": [1, [2, 3], [4, 5]], "a26161016162820203": {"a": 1, "b": [2, 3]},
    "9f01820203820405ff": [1, [2, 3], [4, 5]], "bf61610161629f0203ffff": {"a": 1, "b": [2, 3]}, "7f657374726561646d696e67ff": "streaming",
    "d9d9f700": 0, "d8464401000000": [1], "d85648000000000000f03f": [1.0], "d84e44ffffffff": [-1],
    "d8554400000040": [2.0], "d84044010203ff": [1, 2, 3, 255], "d85240": [],
}


class Decoder(unittest.TestCase):
    def test_what_the_standards_print(self):
        for text, value in CASES.items():
            data = bytes.fromhex(text)
            item, end = cbor.decode(data)
            self.assertEqual((item, type(item), end), (value, type(value), len(data)), text)

    def test_what_ends_too_soon_or_is_no_cbor(self):
        for text in ("18", "62c3", "8301", "a161", "d85641", "1c", "ff00", "a1016161", "d85648000000000000f07f", "a2616101616102"):
            with self.assertRaises((AssertionError, IndexError, KeyError, UnicodeDecodeError), msg=text):
                list(cbor.sequence(bytes.fromhex(text)))

    def test_sequences(self):
        self.assertEqual(list(cbor.sequence(bytes.fromhex("0102a0"))), [1, 2, {}])


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
